// SPDX-License-Identifier: MIT-0
// Smith's masking and shadowing. Each function below gives S(c) = c / G1, for the cosine c >= 0 and
// the squared sine s2 of a direction, which stays finite at the horizon and is a sum of positive
// terms: c (1 + Lambda) for the profiles that have a Lambda.
#include "lib/elementary.glsl"
#include "lib/math.glsl"

// GGX: S = (c + sqrt(alpha^2 s^2 + c^2)) / 2. Walter et al., EGSR 2007, equation 34.
float ggxUnmasked(float c, float s2, float alpha) {
    return 0.5 * (c + sqrt(alpha * alpha * s2 + c * c));
}

// Beckmann: with a = c / (alpha s), S = c + alpha s ierfc(a) / 2, from
// Lambda = (e^(-a^2) / (a sqrt pi) - erfc a) / 2. Smith, IEEE Trans. AP 15(5), 1967; Walter et al.
// 2007, equation 26.
float beckmannUnmasked(float c, float s2, float alpha) {
    float width = alpha * sqrt(s2);
    return c + 0.5 * width * ierfc(c / max(width, 1e-30));
}

// Schlick's rational approximation: S = c (1 - k) + k, 0 <= k <= 1.
// Schlick, An Inexpensive BRDF Model for Physically-based Rendering, CGF 13(3), 1994; k = alpha
// sqrt(2 / pi) for Beckmann, alpha / 2 for GGX (Karis, Real Shading in Unreal Engine 4, SIGGRAPH
// 2013 course).
float schlickUnmasked(float c, float k) {
    return c + k * (1.0 - c);
}

// G / (4 n.v) with G = G1(l) G1(v), light and viewer masked independently.
float separableVisibility(float nl, float Sl, float Sv) {
    return 0.25 * nl / (Sl * Sv);
}

// G / (4 n.v) with G = 1 / (1 + Lambda(l) + Lambda(v)): the deeper a point lies, the more it is
// hidden from both. Ross, Dion and Potvin, JOSA A 22(11), 2005; Heitz, JCGT 3(2), 2014, equation
// 99. 1e-37 keeps 0 / 0 away where both directions graze within a few of the smallest floats.
float correlatedVisibility(float nl, float nv, float Sl, float Sv) {
    return 0.25 * nl / max(nv * Sl + nl * (Sv - nv), 1e-37);
}
