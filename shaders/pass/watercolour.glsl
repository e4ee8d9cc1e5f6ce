// SPDX-License-Identifier: MIT-0
#include "lib/picture_point.glsl"

// The place from the middle of the picture, in units of a size.
vec2 watercolourUnits(PicturePoint at, float size) {
    return (at.pixel - 0.5 * at.size) * (1.0 / (at.scale * max(size, 0.01)));
}

// How many sizes of hills a noise has that has `fine` of them when samples are.
int watercolourOctaves(int fine, WatercolourPass p) {
    int fewer = 1;
    return p.samples == WATERCOLOUR_PASS_SAMPLES_COARSE ? fine - fewer : fine;
}

// How many places are looked at on each side.
int watercolourReach(WatercolourPass p) {
    int coarse = 3;
    int fine = 6;
    return p.samples == WATERCOLOUR_PASS_SAMPLES_COARSE ? coarse : fine;
}

// The height of the paper, -1 .. 1 and somewhat beyond.
float watercolourPaper(PicturePoint at, WatercolourPass p) {
    int octaves = 3;
    return pictureTurbulence(watercolourUnits(at, p.grainSize), watercolourOctaves(octaves, p));
}

// Where the brush was that should have been here.
vec2 watercolourBrush(PicturePoint at, WatercolourPass p) {
    vec2 u = watercolourUnits(at, 9.0);
    int octaves = 2;
    int some = watercolourOctaves(octaves, p);
    vec2 off = vec2(pictureTurbulence(u, some), pictureTurbulence(u + vec2(91.7, 43.1), some));
    return at.pixel + (p.wobble * at.scale) * off;
}

// The mean along a row, and in w how much of it shows objects.
vec4 watercolourPassAcross(PicturePoint at, WatercolourPass p) {
    int reach = watercolourReach(p);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float x = float(i) / float(reach);
        vec2 pixel = at.pixel + vec2(x * p.width * at.scale, 0.0);
        float weight = exp(-3.0 * x * x);
        vec3 color = pictureColor(pixel);
        float there = pictureSurface(pixel).number > 0.0 ? 1.0 : 0.0;
        sum += weight * vec4(color.r, color.g, color.b, there);
        weights += weight;
    }
    return sum * (1.0 / weights);
}

vec4 watercolourPassWash(PicturePoint at, WatercolourPass p) {
    int reach = watercolourReach(p);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float x = float(i) / float(reach);
        float weight = exp(-3.0 * x * x);
        sum += weight * stageValue(at.pixel + vec2(0.0, x * p.width * at.scale));
        weights += weight;
    }
    return sum * (1.0 / weights);
}

// How much the washes around a place differ, 0 .. 1 and beyond: that of colours as the eye sees
// them, and of what is there.
float watercolourEdge(vec2 pixel, float apart) {
    vec4 left = sqrt(max(stageValue(pixel - vec2(apart, 0.0)), vec4(0.0)));
    vec4 right = sqrt(max(stageValue(pixel + vec2(apart, 0.0)), vec4(0.0)));
    vec4 below = sqrt(max(stageValue(pixel - vec2(0.0, apart)), vec4(0.0)));
    vec4 above = sqrt(max(stageValue(pixel + vec2(0.0, apart)), vec4(0.0)));
    vec4 x = right - left;
    vec4 y = above - below;
    return sqrt(dot(x, x) + dot(y, y));
}

vec3 watercolourPass(PicturePoint at, WatercolourPass p) {
    vec2 pixel = watercolourBrush(at, p);
    vec3 color = pictureColor(pixel);
    bool bare = p.background == WATERCOLOUR_PASS_BACKGROUND_BARE &&
                pictureSurface(pixel).number <= 0.0;
    float paper = watercolourPaper(at, p);
    int octaves = 3;
    float clouds =
        pictureTurbulence(watercolourUnits(at, p.pigmentSize), watercolourOctaves(octaves, p));
    float edge = watercolourEdge(pixel, max(0.5 * p.width * at.scale, 0.5));
    float density = 1.0 - 0.35 * p.grain * paper + 0.5 * p.pigment * clouds + p.edges * edge;
    density = max(density, 0.05) * (1.0 - p.thinness);
    vec3 light = clamp(color, vec3(0.002), vec3(1.0));
    vec3 passed = vec3(pow(light.r, density), pow(light.g, density), pow(light.b, density));
    float shade = 1.0 + 0.06 * p.grain * paper; // of the bare paper itself
    return p.paper * clamp(shade, 0.0, 1.2) * (bare ? vec3(1.0) : passed);
}
