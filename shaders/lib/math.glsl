// SPDX-License-Identifier: MIT-0
// Small arithmetic that every other file leans on.

const float PI = 3.14159265358979324;

// x^2.
float sqr(float x) {
    return x * x;
}

// x^5 in three multiplications, for any x: pow(x, 5.0) has no value for x < 0 in GLSL.
float pow5(float x) {
    float x2 = x * x;
    return x2 * x2 * x;
}

// a where t is 0, b where it is 1. GLSL's mix may add t (b - a) to a, which loses a b that is small
// beside a.
vec3 lerp(vec3 a, vec3 b, float t) {
    return a * (1.0 - t) + b * t;
}

// 1 up to low, 0 from high on, low < high: 1 - smoothstep(low, high, x) with every digit of a small
// rest.
float fallingStep(float low, float high, float x) {
    return smoothstep(-high, -low, -x);
}

// a up to low, b from high on, low < high: both with every digit of a small share.
vec3 smoothLerp(vec3 a, vec3 b, float low, float high, float x) {
    return a * fallingStep(low, high, x) + b * smoothstep(low, high, x);
}

// sqrt(x) for x > 0, else 0: a difference that rounding made negative is a zero.
float safeSqrt(float x) {
    return sqrt(max(x, 0.0));
}

// v / |v|, or `fallback` where v has no direction. The largest component is divided out first, so
// neither a long nor a short vector leaves the range of a float when it is squared.
// Valid for any finite v; components below 1e-30 count as zero because GPUs flush what is smaller.
vec3 safeNormalize(vec3 v, vec3 fallback) {
    float size = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(size > 1e-30)) {
        return fallback;
    }
    vec3 u = v / size;
    return u / sqrt(dot(u, u));
}

// The same for lengths between 1e-15 and 1e18, as places and directions in a scene have: one square
// root and one division.
vec3 unitVector(vec3 v, vec3 fallback) {
    float length2 = dot(v, v);
    vec3 unit = v * inversesqrt(max(length2, 1e-30));
    return length2 > 1e-30 ? unit : fallback;
}

// The width of a microfacet distribution from the slider's roughness, which is the RMS slope m of
// Cook and Torrance 1982: alpha = m. At 0 the lobe is a Dirac delta that has no finite value under
// a point light, so widths below 1e-4 are drawn as 1e-4: 1 / (pi 1e-8) still fits a float.
float slopeWidth(float roughness) {
    return max(roughness, 1e-4);
}
