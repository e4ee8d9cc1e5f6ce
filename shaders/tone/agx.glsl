// SPDX-License-Identifier: MIT-0
#include "lib/math.glsl"

// The fit of AgX's default contrast (Wrensch 2023), 15.5 x^6 - 40.14 x^5 + 31.96 x^4 - 6.868 x^3 +
// 0.4298 x^2 + 0.1191 x - 0.00232: a little below 0 at 0. Above 0.4, where these terms are far larger
// than their sum, the same by powers of x - 0.5.
float agxContrast(float x) {
    if (x < 0.4) {
        return (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x -
            0.00232;
    }
    float t = x - 0.5;
    return (((((15.5 * t + 6.36) * t - 10.265) * t - 4.548) * t + 2.42405) * t + 1.7404) * t +
        0.2914925;
}

// The place on the logarithmic scale from -12.47393 to 4.026069 stops, through the curve.
float agxCurve(float x) {
    const float LOWEST = -12.47393;
    const float HIGHEST = 4.026069;
    float stops = clamp(log2(max(x, 1e-10)), LOWEST, HIGHEST);
    return agxContrast((stops - LOWEST) / (HIGHEST - LOWEST));
}

// Moved towards grey, through the curve, back, and from a display's power of 2.2 to linear light.
vec3 agxTone(vec3 light, AgxTone p) {
    float r = agxCurve(0.842479062253094 * light.r + 0.0784335999999992 * light.g +
        0.0792237451477643 * light.b);
    float g = agxCurve(0.0423282422610123 * light.r + 0.878468636469772 * light.g +
        0.0791661274605434 * light.b);
    float b = agxCurve(0.0423756549057051 * light.r + 0.0784336 * light.g +
        0.879142973793104 * light.b);
    vec3 shown = vec3(1.19687900512017 * r - 0.0980208811401368 * g - 0.0990297440797205 * b,
        -0.0528968517574562 * r + 1.15190312990417 * g - 0.0989611768448433 * b,
        -0.0529716355144438 * r - 0.0980434501171241 * g + 1.15107367264116 * b);
    return vec3(pow(max(shown.r, 0.0), 2.2), pow(max(shown.g, 0.0), 2.2),
        pow(max(shown.b, 0.0), 2.2));
}
