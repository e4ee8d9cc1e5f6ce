// SPDX-License-Identifier: MIT-0
// The environment on one face of a cube, each texel the mean over its part.
#include "passes/cube_face.glsl"

layout(location = 0) out vec4 storedRadiance;

const int SIDE = 3;

void main() {
    Environment p = unpackEnvironment(2);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SIDE * SIDE; ++i) {
        vec2 within = (vec2(float(i % SIDE), float(i / SIDE)) + 0.5) / float(SIDE);
        sum += environmentRadiance(faceDirection(floor(gl_FragCoord.xy) + within), p);
    }
    storedRadiance = vec4(sum / float(SIDE * SIDE), 1.0);
}
