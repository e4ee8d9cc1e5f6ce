// SPDX-License-Identifier: MIT-0
// The environment as a picture: each pixel is the mean over its own part of all directions, looked at in
// PART_SIDE by PART_SIDE places. DIRECTION_AT(p) says where a place lies that is given in pixels.

layout(location = 0) out vec4 storedRadiance;

void main() {
    Environment p = unpackEnvironment(2);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < PART_SIDE * PART_SIDE; ++i) {
        vec2 within = (vec2(float(i % PART_SIDE), float(i / PART_SIDE)) + 0.5) / float(PART_SIDE);
        sum += environmentRadiance(DIRECTION_AT(floor(gl_FragCoord.xy) + within), p);
    }
    storedRadiance = vec4(sum / float(PART_SIDE * PART_SIDE), 1.0);
}
