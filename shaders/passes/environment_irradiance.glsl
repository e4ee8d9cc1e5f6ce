// SPDX-License-Identifier: MIT-0
// What a white matte surface shows, by direction of its normal.
vec3 environmentIrradiance(vec3 n) {
    const int C = ENVIRONMENT_HARMONICS;
    vec3 linear = environmentData[C].rgb + n.y * environmentData[C + 1].rgb +
                  n.z * environmentData[C + 2].rgb + n.x * environmentData[C + 3].rgb;
    vec3 square = n.x * n.y * environmentData[C + 4].rgb + n.y * n.z * environmentData[C + 5].rgb +
                  (3.0 * n.z * n.z - 1.0) * environmentData[C + 6].rgb +
                  n.x * n.z * environmentData[C + 7].rgb +
                  (n.x * n.x - n.y * n.y) * environmentData[C + 8].rgb;
    return max(linear + square, vec3(0.0));
}
