// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// n^2 - n0^2 sin^2, in the form that loses less where n and n0 are large.
float squareAcross(float n, float n0, Incidence i) {
    float u0 = n0 * i.c;
    return i.c * i.c > 0.5 ? n * n - n0 * n0 * sin2Incidence(i) : (n - n0) * (n + n0) + u0 * u0;
}

// sin(x) and tanh(x) for x >= 0, whose first digits a device may lose for small x.
float filmSin(float x) {
    float x2 = x * x;
    return x < 0.1 ? x * (1.0 - x2 * (1.0 / 6.0 - x2 * (1.0 / 120.0 - x2 / 5040.0))) : sin(x);
}

float filmTanh(float x) {
    float x2 = x * x;
    float e = exp(-2.0 * x);
    float series = 2.0 / 15.0 - x2 * (17.0 / 315.0 - x2 * 62.0 / 2835.0);
    return x < 0.05 ? x * (1.0 - x2 * (1.0 / 3.0 - x2 * series)) : (1.0 - e) / (1.0 + e);
}

// |difference / sum|^2 of two numbers B and C, of which `through` is Re(B conj(C)): nearly all is
// what does not go through, nearly none is what differs. 1 where both are 0: at grazing angles.
float filmShare(vec2 difference, vec2 sum, float through) {
    float below = dot(sum, sum);
    if (!(below > 0.0)) {
        return 1.0;
    }
    float left = 4.0 * max(through, 0.0) / below;
    return left < 0.5 ? 1.0 - left : min(dot(difference, difference) / below, 1.0);
}

// Reflectance of a film of the index n1 and of the phase 2 pi d / lambda per unit of u1 on the
// index eta + i k, seen from n0, the mean of both polarisations. With u_j = sqrt(n_j^2 - n0^2
// sin^2), delta = u1 phase, S1 = sin(delta) / u1 and S2 = u1 sin(delta), the characteristic matrix
// gives
//   s: r = (u0 B - C) / (u0 B + C),  B = cos(delta) - i S1 u2,  C = cos(delta) u2 - i S2
//   p: the same with n0^2 B and u0 C, B = cos(delta) u2 - i S2 N2 / n1^2,
//      C = cos(delta) N2 - i n1^2 S1 u2,  N2 = (eta + i k)^2
// Born and Wolf, Principles of Optics, section 1.6. Beyond the film's critical angle u1 is
// imaginary and everything is divided by cosh. A^2 + S1 S2, the matrix' determinant, is 1, or then
// 1 / cosh^2.
float filmReflectance(Incidence i, float n0, float n1, float phase, float eta, float k) {
    float u0 = n0 * i.c;
    float u12 = squareAcross(n1, n0, i);
    float w = sqrt(abs(u12));
    float x = phase * w;
    float A = 1.0;
    float S1 = phase;
    float S2 = 0.0;
    float determinant = 1.0;
    if (u12 > 0.0) {
        A = cos(x);
        S1 = filmSin(x) / w;
        S2 = w * filmSin(x);
    } else if (u12 < 0.0) {
        float e = exp(-2.0 * x);
        float t = filmTanh(x);
        S1 = t / w;
        S2 = -w * t;
        determinant = 4.0 * e / ((1.0 + e) * (1.0 + e));
    }
    vec2 N2 = vec2((eta - k) * (eta + k), 2.0 * eta * k);
    float t = squareAcross(eta, n0, i) - k * k;
    float big = 0.5 * (sqrt(t * t + N2.y * N2.y) + abs(t));
    float less = 0.25 * N2.y * N2.y / max(big, 1e-30);
    vec2 u2 = vec2(sqrt(t > 0.0 ? big : less), sqrt(t > 0.0 ? less : big));
    vec2 sum = u2 + vec2(u0, 0.0);
    vec2 change = vec2((n0 - eta) * (n0 + eta) + k * k, -N2.y); // n0^2 - N2
    vec2 gap = vec2(dot(change, sum), change.y * sum.x - change.x * sum.y) /
                max(dot(sum, sum), 1e-30); // u0 - u2, which loses nothing where they are near
    vec2 B = vec2(A + S1 * u2.y, -S1 * u2.x) * u0;
    vec2 C = vec2(A * u2.x, A * u2.y - S2);
    vec2 difference = A * gap + vec2(S1 * u0 * u2.y, S2 - S1 * u0 * u2.x);
    float Rs = filmShare(difference, B + C, u0 * u2.x * determinant);
    float n02 = n0 * n0;
    float n12 = n1 * n1;
    B = vec2(A * u2.x + S2 * N2.y / n12, A * u2.y - S2 * N2.x / n12) * n02;
    C = vec2(A * N2.x + n12 * S1 * u2.y, A * N2.y - n12 * S1 * u2.x) * u0;
    vec2 z = n02 * S2 / n12 * N2 - u0 * n12 * S1 * u2;
    difference = A * (u0 * change - n02 * gap) + vec2(z.y, -z.x);
    return 0.5 * (Rs + filmShare(difference, B + C, n02 * u0 * dot(u2, N2) * determinant));
}

// Per channel, at its wavelength.
vec3 thinFilmFresnel(Incidence i, ThinFilmFresnel p) {
    vec3 phase = vec3(2.0 * PI * p.filmThickness) / p.wavelength;
    return vec3(filmReflectance(i, p.indexOutside, p.filmIndex, phase.x, p.eta.x, p.k.x),
                filmReflectance(i, p.indexOutside, p.filmIndex, phase.y, p.eta.y, p.k.y),
                filmReflectance(i, p.indexOutside, p.filmIndex, phase.z, p.eta.z, p.k.z));
}

vec3 thinFilmFresnelTint(ThinFilmFresnel p) {
    return p.color;
}

// The reflectance of light that swings across the plane of incidence. It knows the media by u_j
// alone, so it is that of media of the indices u_j seen straight; where u1 is 0 or imaginary it is
// worked out by the matrix of s, with everything divided by cosh.
float filmAcross(Incidence i, float n0, float n1, float phase, float eta, float k) {
    float u0 = n0 * i.c;
    float u12 = squareAcross(n1, n0, i);
    float imaginary = 2.0 * eta * k;
    float t = squareAcross(eta, n0, i) - k * k;
    float big = 0.5 * (sqrt(t * t + imaginary * imaginary) + abs(t));
    float less = 0.25 * imaginary * imaginary / max(big, 1e-30);
    vec2 u2 = vec2(sqrt(t > 0.0 ? big : less), sqrt(t > 0.0 ? less : big));
    if (u12 > 1e-10) {
        return filmReflectance(incidenceOf(1.0), u0, sqrt(u12), phase, u2.x, u2.y);
    }
    float w = sqrt(max(-u12, 0.0));
    float x = phase * w;
    float e = exp(-2.0 * x);
    float S1 = w > 1e-10 ? filmTanh(x) / w : phase;
    float S2 = -w * filmTanh(x);
    vec2 B = vec2(1.0 + S1 * u2.y, -S1 * u2.x) * u0;
    vec2 C = vec2(u2.x, u2.y - S2);
    return filmShare(B - C, B + C, u0 * u2.x * 4.0 * e / ((1.0 + e) * (1.0 + e)));
}

// The same per channel, at its wavelength.
vec3 thinFilmFresnelAcross(Incidence i, ThinFilmFresnel p) {
    vec3 phase = vec3(2.0 * PI * p.filmThickness) / p.wavelength;
    return vec3(filmAcross(i, p.indexOutside, p.filmIndex, phase.x, p.eta.x, p.k.x),
                filmAcross(i, p.indexOutside, p.filmIndex, phase.y, p.eta.y, p.k.y),
                filmAcross(i, p.indexOutside, p.filmIndex, phase.z, p.eta.z, p.k.z));
}
