// SPDX-License-Identifier: MIT-0

// x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) (Narkowicz 2015), divided by x above 1, where the
// squares could overflow.
float acesCurve(float x) {
    if (x <= 1.0) {
        return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
    }
    return (2.51 * x + 0.03) / (2.43 * x + 0.59 + 0.14 / x);
}

vec3 acesTone(vec3 light, AcesTone p) {
    return vec3(acesCurve(light.r), acesCurve(light.g), acesCurve(light.b));
}
