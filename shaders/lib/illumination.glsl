// SPDX-License-Identifier: MIT-0
#include "lib/math.glsl"

// What one light sends to one point.
struct Illumination {
    vec3 l;        // unit, from the point towards the light
    vec3 radiance; // colour times attenuation, E / pi: a white Lambert surface facing l shows this
};

// Metres to a light. Nearer than 1e-15, where the square of a float is 0 and no direction is left,
// counts as at the light itself.
float metresTo(vec3 toLight) {
    float x = length(toLight);
    return x > 1e-15 ? x : 0.0;
}

// 1 / (constant + linear x + quadratic x^2) at the distance x, never above 10 000: with all three
// at 0, or at the light itself, the formula has no finite value. In Horner's form x^2 alone cannot
// overflow. OpenGL 1.0 specification (1992), lighting; x >= 0, coefficients >= 0.
float polynomialAttenuation(float x, float constant, float linear, float quadratic) {
    return 1.0 / max(constant + x * (linear + quadratic * x), 1e-4);
}

// 1 / x^2 for a light that is not a point but has the radius `minimum` > 0: nearer than that the
// light is no brighter. x and minimum in metres; 1 at one metre.
float inverseSquareAttenuation(float x, float minimum) {
    return 1.0 / sqr(max(x, minimum));
}

// 1 near a light and 0 from `range` > 0 metres on, without an edge: 1 - (x / range)^4, as factors
// so that the digits are kept where it ends. KHR_lights_punctual (2017).
float rangeWindow(float x, float range) {
    float share = min(x / range, 1.0);
    return max(range - x, 0.0) / range * ((1.0 + share) * (1.0 + share * share));
}

// What is left at x metres from a light in one place: by the inverse square with its `minimum`, or
// by the polynomial; a `range` above 0 ends it.
float distanceAttenuation(float x, bool isInverseSquare, float minimum, float constant,
    float linear, float quadratic, float range) {
    float attenuation = isInverseSquare
        ? inverseSquareAttenuation(x, minimum)
        : polynomialAttenuation(x, constant, linear, quadratic);
    return range > 0.0 ? attenuation * rangeWindow(x, range) : attenuation;
}
