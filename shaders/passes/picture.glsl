// SPDX-License-Identifier: MIT-0
// What a pass over the picture reads. Beside the picture is what its edge shows.
#include "lib/picture_point.glsl"

uniform sampler2D pictureImage; // as it was before the pass, sRGB encoded
uniform sampler2D stageImage;   // what the pass's last stage drew
uniform float pictureLevels;    // the last of the picture's smaller levels, each half as wide

layout(location = 0) out vec4 drawn;

PicturePoint picturePoint() {
    PicturePoint at;
    at.pixel = gl_FragCoord.xy;
    at.size = vec2(textureSize(pictureImage, 0));
    at.scale = at.size.y / 512.0;
    return at;
}

vec3 encodedColor(vec2 pixel) {
    return textureLod(pictureImage, pixel / vec2(textureSize(pictureImage, 0)), 0.0).rgb;
}

vec3 encodedMean(vec2 pixel, float width) {
    float level = clamp(log2(max(width, 1.0)), 0.0, pictureLevels);
    return textureLod(pictureImage, pixel / vec2(textureSize(pictureImage, 0)), level).rgb;
}

// What the stage before this one drew; before the first one nothing has been.
vec4 stageValue(vec2 pixel) {
    return textureLod(stageImage, pixel / vec2(textureSize(stageImage, 0)), 0.0);
}

// What is not a number is no colour.
float shownPart(float x) {
    return x > 0.0 ? min(x, 1.0) : 0.0;
}

// A half float ends at 65504.
float keptPart(float x) {
    return abs(x) <= 65504.0 ? x : (x > 0.0 ? 65504.0 : (x < 0.0 ? -65504.0 : 0.0));
}

vec4 kept(vec4 value) {
    return vec4(keptPart(value.x), keptPart(value.y), keptPart(value.z), keptPart(value.w));
}

// A number from 0 to below 1 for each pair of whole numbers: two rounds of a linear congruential
// generator, mixed (after M. Jarzynski and M. Olano, Hash Functions for GPU Rendering, JCGT 9(3),
// 2020).
float pictureRandom(ivec2 cell) {
    uvec2 v = uvec2(cell) * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> 16u;
    return float(v.x >> 8u) / 16777216.0;
}

// What a multiple of the golden ratio is above a whole number, counted in 2^32nds, since a float holds
// too few digits.
float pictureGolden(int number) {
    return (float((uint(number) * 2654435769u) >> 8u) + 0.5) / 16777216.0;
}

// Noise from 0 to 1 whose hills are about a unit apart, without a jump in its slope; beyond 1e6 it
// is even.
float pictureNoise(vec2 place) {
    vec2 near = clamp(place, vec2(-1e6), vec2(1e6));
    ivec2 cell = ivec2(floor(near));
    vec2 f = near - vec2(cell);
    vec2 s = f * f * (3.0 - 2.0 * f);
    float below = mix(pictureRandom(cell), pictureRandom(cell + ivec2(1, 0)), s.x);
    float above = mix(pictureRandom(cell + ivec2(0, 1)), pictureRandom(cell + ivec2(1, 1)), s.x);
    return mix(below, above, s.y);
}

// Octaves of noise, each turned against the one before: about -1 to 1, the mean 0.
float pictureTurbulence(vec2 place, int octaves) {
    float sum = 0.0;
    float share = 1.0;
    vec2 at = place;
    for (int i = 0; i < octaves; ++i) {
        sum += share * (2.0 * pictureNoise(at) - 1.0);
        at = vec2(1.6 * at.x + 1.2 * at.y + 17.3, 1.6 * at.y - 1.2 * at.x + 5.1);
        share *= 0.55;
    }
    return sum;
}
