// SPDX-License-Identifier: MIT-0
// The environment of the scene: its values, the way from directions to places in its pictures, and
// what it sends from a direction.
#include "lib/sky_ray.glsl"

// 0: cosine and sine of its rotation, the first round of samples, how many rounds; 1: columns and
// rows of its table, how many samples, which series of them; then the block's own values.
layout(std140) uniform EnvironmentBlock {
    vec4 environmentData[ENVIRONMENT_VEC4S];
};

// Where a direction of the environment lies in its pictures: across from -z over +x back to -z
// with -z in the middle, down from straight up.
vec2 environmentPlace(vec3 d) {
    float across = atan(d.x, -d.z) / (2.0 * PI) + 0.5;
    float down = atan(length(vec2(d.x, d.z)), d.y) / PI;
    return vec2(across, down);
}

vec3 environmentDirectionAt(vec2 place) {
    float across = (place.x - 0.5) * 2.0 * PI;
    float down = place.y * PI;
    return vec3(sin(down) * sin(across), cos(down), -sin(down) * cos(across));
}

// From the world into the environment, which is turned about the upward axis, and back.
vec3 environmentInside(vec3 d) {
    vec2 turn = environmentData[0].xy;
    return vec3(turn.x * d.x - turn.y * d.z, d.y, turn.y * d.x + turn.x * d.z);
}

vec3 environmentOutside(vec3 d) {
    vec2 turn = environmentData[0].xy;
    return vec3(turn.x * d.x + turn.y * d.z, d.y, turn.x * d.z - turn.y * d.x);
}

// Light as a half float holds it; what is not a number is not light.
vec3 environmentLimited(vec3 x) {
    return vec3(x.r > 0.0 ? min(x.r, 65504.0) : 0.0, x.g > 0.0 ? min(x.g, 65504.0) : 0.0,
        x.b > 0.0 ? min(x.b, 65504.0) : 0.0);
}
