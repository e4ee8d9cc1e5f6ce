// SPDX-License-Identifier: MIT-0
// What becomes of a ray that meets the surface of a transparent body, from outside or from within.
#include "lib/elementary.glsl"
#include "lib/fresnel.glsl"
#include "lib/incidence.glsl"
#include "lib/math.glsl"
#include "lib/refraction.glsl"

struct Interface {
    vec3 l;      // unit, from the surface to where the ray comes from
    vec3 n;      // unit normal on the side of l
    int channel; // 0, 1, 2: red, green, blue light
    bool leaves; // from the body into what surrounds it, else the other way round
};

// The lines F (486.1 nm), d (587.6 nm) and C (656.3 nm) by which dispersion is stated, and the
// wavelengths that stand for red, green and blue, in micrometres.
const float LINE_F = 0.4861;
const float LINE_D = 0.5876;
const float LINE_C = 0.6563;
const float LINE_RED = 0.65;
const float LINE_GREEN = 0.55;
const float LINE_BLUE = 0.45;

// The indices for red, green and blue light of a body whose index for the line d is given, and
// whose dispersion is 20 over its Abbe number (n_d - 1) / (n_F - n_C); 0 refracts all alike.
// Cauchy's two terms through these: n = n_d + B (1 / lambda^2 - 1 / lambda_d^2). At least 0.01.
vec3 dispersedIndices(float index, float dispersion) {
    float spread = 0.05 * dispersion * (index - 1.0);
    float B = spread / (1.0 / (LINE_F * LINE_F) - 1.0 / (LINE_C * LINE_C));
    float A = index - B / (LINE_D * LINE_D);
    vec3 indices = cauchyIndex(vec3(LINE_RED, LINE_GREEN, LINE_BLUE), A, B, 0.0);
    return max(indices, vec3(0.01));
}

// The index beyond the surface over that on the side of l, of a body with these indices relative to
// what surrounds it.
float indexBeyond(Interface c, vec3 indices) {
    return c.leaves ? 1.0 / indices[c.channel] : indices[c.channel];
}

// The unit direction in which the ray goes on; the zero vector where all is reflected.
vec3 crossedDirection(Interface c, vec3 indices) {
    return refractedDirection(c.l, c.n, indexBeyond(c, indices));
}

// The share of ordinary light that the surface reflects; 1 where nothing passes.
float crossedReflectance(Interface c, vec3 indices) {
    float Rs;
    float Rp;
    dielectricReflectances(incidenceBetween(c.l, c.n), 1.0, indexBeyond(c, indices), Rs, Rp);
    return 0.5 * (Rs + Rp);
}

// The reflectance of two parallel surfaces that reflect R each, with all that goes to and fro
// between them: R + (1 - R)^2 R (1 + R^2 + ...) = 2 R / (1 + R).
float paneReflectance(float R) {
    return 2.0 * R / (1.0 + R);
}

// What is left of white light after `way` metres in a body that leaves `left` of it after `reach`
// metres: left^(way / reach). P. Bouguer 1729. way >= 0; left 0 .. 1; reach > 0. From 1e30 reaches
// on only light that loses nothing is left: an infinite way times its logarithm, 0, is no number.
// 1 - left is exact where the logarithm of a float would lose it.
vec3 leftAfter(float way, vec3 left, float reach) {
    float reaches = min(way / reach, 1e30);
    vec3 some = max(left, vec3(1e-30));
    vec3 lost = vec3(1.0) - some;
    return vec3(pow1m(lost.r, some.r, reaches), pow1m(lost.g, some.g, reaches),
        pow1m(lost.b, some.b, reaches));
}
