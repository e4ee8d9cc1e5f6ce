// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/fresnel.glsl"
#include "lib/gloss.glsl"
#include "lib/masking.glsl"
#include "lib/math.glsl"

// How much a unit of slope counts along and across the grain, 1 / aspect^2 and aspect^2 (Burley
// 2012, section 5.4, whose x is across the grain here): alpha aspect is the width along it and
// alpha / aspect the one across, aspect^2 between 0.1 and 1.
vec2 anisotropicGgxWeights(AnisotropicGgx p) {
    float aspect2 = 1.0 - 0.9 * p.anisotropy;
    return vec2(1.0 / aspect2, aspect2);
}

// D in 1/sr, integral of D cos = 1: 1 / (pi ax ay (tan^2 (cos^2 / ax^2 + sin^2 / ay^2) + 1)^2
// cos^4) with the azimuth from the grain (Heitz 2014, equation 85). With ax ay = alpha^2 that is
// GGX of alpha for a half vector whose tangents are weighted. 1e-36 keeps 0 / 0 away where light
// and viewer oppose each other within the surface.
float anisotropicGgxDistribution(Directions d, AnisotropicGgx p) {
    float alpha = slopeWidth(p.roughness);
    vec2 weight = anisotropicGgxWeights(p);
    Directions g = alongGrain(d, p.tangentAngle);
    float sine2 = weight.x * sqr(g.tH) + weight.y * sqr(g.bH);
    float r = d.HH / max(alpha * alpha * d.cos2h + sine2, 1e-36);
    return alpha * alpha * r * r / PI;
}

// G / (4 n.v), Smith's by height (Heitz 2014, equation 99).
float anisotropicGgxVisibility(Directions d, AnisotropicGgx p) {
    float alpha = slopeWidth(p.roughness);
    vec2 weight = anisotropicGgxWeights(p);
    Directions g = alongGrain(d, p.tangentAngle);
    float Sl = ggxUnmasked(d.nl, weight.y * sqr(g.lt) + weight.x * sqr(g.lb), alpha);
    float Sv = ggxUnmasked(d.nv, weight.y * sqr(g.vt) + weight.x * sqr(g.vb), alpha);
    return correlatedVisibility(d.nl, d.nv, Sl, Sv);
}

// G, for plots of the masking alone.
float anisotropicGgxMasking(Directions d, AnisotropicGgx p) {
    return 4.0 * d.nv * anisotropicGgxVisibility(d, p);
}

// rho n.l + pi D G F / (4 n.v).
vec3 anisotropicGgx(Directions d, AnisotropicGgx p) {
    vec3 F = slotFresnel(halfIncidence(d), p.fresnel);
    float lobe = PI * anisotropicGgxDistribution(d, p) * anisotropicGgxVisibility(d, p);
    return p.diffuseColor * d.nl
        + glossedLobe(p.specularColor * F, lobe, p.gloss,
            p.glossMode == ANISOTROPIC_GGX_GLOSS_MODE_LIMIT, d.nl);
}
