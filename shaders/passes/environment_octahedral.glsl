// SPDX-License-Identifier: MIT-0
// The environment as level 0 of an octahedral picture, each texel the mean over its part.
#include "passes/octahedral_levels.glsl"

layout(location = 0) out vec4 storedRadiance;

const int SIDE = 2;

void main() {
    Environment p = unpackEnvironment(2);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SIDE * SIDE; ++i) {
        vec2 within = (vec2(float(i % SIDE), float(i / SIDE)) + 0.5) / float(SIDE);
        vec2 place = (floor(gl_FragCoord.xy) - 1.0 + within) / (OCTAHEDRAL_WIDTH - 2.0);
        sum += environmentRadiance(octahedralDirection(place), p);
    }
    storedRadiance = vec4(sum / float(SIDE * SIDE), 1.0);
}
