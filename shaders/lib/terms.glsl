// SPDX-License-Identifier: MIT-0
// The terms of microfacet models as functions of plain cosines, the way papers print them, for
// checking values from outside. Models use the forms they call, which keep small angles.
#include "lib/incidence.glsl"
#include "lib/masking.glsl"
#include "lib/microfacet.glsl"

// cos^2 and sin^2 of a cosine; below the horizon counts as at the horizon.
float cosineSquared(float c) {
    return c > 0.0 ? min(c * c, 1.0) : 0.0;
}
float sineSquared(float c) {
    return c > 0.0 ? max((1.0 - c) * (1.0 + c), 0.0) : 1.0;
}

// Beckmann, normalised: exp(-tan^2 / alpha^2) / (pi alpha^2 (n.h)^4).
float beckmannD(float nh, float alpha) {
    return beckmannDistribution(sineSquared(nh), cosineSquared(nh), slopeWidth(alpha));
}

// GGX: alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2).
float ggxD(float nh, float alpha) {
    return ggxDistribution(sineSquared(nh), cosineSquared(nh), slopeWidth(alpha));
}

// Trowbridge and Reitz as Blinn 1977 prints it (D3): (c3^2 / ((n.h)^2 (c3^2 - 1) + 1))^2, 1 at n =
// h.
float trowbridgeReitzD(float nh, float c3) {
    float alpha = slopeWidth(c3);
    return PI * alpha * alpha * ggxDistribution(sineSquared(nh), cosineSquared(nh), alpha);
}

// The power as a distribution: (e + 2) / (2 pi) (n.h)^e.
float blinnD(float nh, float e) {
    return cosinePowerDistribution(sineSquared(nh), cosineSquared(nh), e);
}

// The power that is a half at the angle beta (Blinn 1977, D1): (n.h)^(-ln 2 / ln cos beta).
float phongD(float nh, float beta) {
    return powSC(sineSquared(nh), cosineSquared(nh), phongExponent(slopeWidth(beta)));
}

// The Gaussian of Cook and Torrance 1982 with the constant 1: e^(-(theta / m)^2).
float gaussianD(float nh, float m) {
    return gaussianLobe(incidenceOf(nh).versine, slopeWidth(m));
}

// e^(-(c2 theta)^2), a half at the angle beta (Blinn 1977, D2): c2 = sqrt(ln 2) / beta.
float torranceSparrowD(float nh, float beta) {
    return gaussianD(nh, gaussianWidth(slopeWidth(beta)));
}

// min(1, 2 (n.h)(n.v) / (v.h), 2 (n.h)(n.l) / (v.h)).
float vCavityG(float nl, float nv, float nh, float vh) {
    return min(1.0, 2.0 * nh * min(nl, nv) / max(vh, 1e-30));
}

// Smith's G1 of one direction, c its cosine with the normal: 1 / (1 + Lambda).
float smithGgxG1(float c, float alpha) {
    return c > 0.0 ? c / ggxUnmasked(c, sineSquared(c), slopeWidth(alpha)) : 0.0;
}
float smithBeckmannG1(float c, float alpha) {
    return c > 0.0 ? c / beckmannUnmasked(c, sineSquared(c), slopeWidth(alpha)) : 0.0;
}
