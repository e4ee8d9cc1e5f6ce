// SPDX-License-Identifier: MIT-0
// The environment as a small picture: each pixel is the mean over its own part of all directions.

layout(location = 0) out vec4 bakedRadiance;

const int SIDE = 4;

void main() {
    Environment p = unpackEnvironment(2);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SIDE * SIDE; ++i) {
        vec2 within = (vec2(float(i % SIDE), float(i / SIDE)) + 0.5) / float(SIDE);
        vec2 place = (floor(gl_FragCoord.xy) + within) / environmentData[1].xy;
        sum += environmentRadiance(environmentDirectionAt(place), p);
    }
    bakedRadiance = vec4(sum / float(SIDE * SIDE), 1.0);
}
