// SPDX-License-Identifier: MIT-0
// Microfacet terms with fewer operations than those of lib/microfacet.glsl and lib/masking.glsl,
// whose arguments they have.
#include "lib/math.glsl"

// Beckmann's distribution with its exponent -tan^2 / alpha^2 - 2 ln cos^2 expanded in s = sin^2
// theta to the second power of s / alpha: -(s + s^2) / alpha^2 + 2 s. The error is below 0.95
// alpha^4 of the peak up to alpha = 0.4; wider lobes no longer fall to 0 at the horizon.
float beckmannSeries(float sin2h, float cos2h, float alpha) {
    float s = sin2h / (sin2h + cos2h);
    float inverse2 = 1.0 / (alpha * alpha);
    return exp2(-1.4426950408889634 * (s * (inverse2 + (s * inverse2 - 2.0)))) * inverse2 / PI;
}

// Smith's masking of a Beckmann surface without the error function: with a = c / (alpha s),
//   G1 = (3.535 a + 2.181 a^2) / (1 + 2.276 a + 2.577 a^2) for a < 1.6, else 1
// (Walter et al., EGSR 2007, equation 27), as S = c / G1. Within 0.63 %.
float walterUnmasked(float c, float s2, float alpha) {
    float width = alpha * sqrt(s2);
    float a = c / max(width, 1e-30);
    float masked = width * (1.0 + a * (2.276 + a * 2.577)) / (3.535 + 2.181 * a);
    return a < 1.6 ? masked : c;
}

// Smith's masking of a GGX surface by height, over 4 n.v, in one division:
// n.l / (2 mix(2 (n.l)(n.v), n.l + n.v, alpha)). E. Hammon, PBR Diffuse Lighting for GGX+Smith
// Microsurfaces, GDC 2017. It is what schlickUnmasked() with k = alpha / 2 gives for two directions
// that are put together by height: with S = c (1 - k) + k,
//   S_l n.v + S_v n.l - (n.l)(n.v) = (1 - alpha) (n.l)(n.v) + alpha / 2 (n.l + n.v).
// nl, nv > 0.
float hammonVisibility(float nl, float nv, float alpha) {
    return 0.5 * nl / max(2.0 * nl * nv * (1.0 - alpha) + (nl + nv) * alpha, 1e-30);
}
