// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/fresnel.glsl"
#include "lib/gloss.glsl"
#include "lib/microfacet.glsl"
#include "lib/powers.glsl"

// The argument x of Strauss's F and G, 0 at the normal and 1 at the horizon, and y = 1 - x. It is
// the angle in right angles: with it F(0) = 0 and G(0) = 1, as the paper requires.
void straussArgument(Strauss p, float c, float s2, OUT(float) x, OUT(float) y) {
    if (p.argument == STRAUSS_ARGUMENT_ANGLE && p.terms == STRAUSS_TERMS_COSINE) {
        x = s2 / (1.0 + c); // 1 - c in the place of the angle, both 0 at the normal
        y = c;
    } else if (p.argument == STRAUSS_ARGUMENT_COSINE) {
        x = c;
        y = s2 / (1.0 + c);
    } else {
        angXY(c, s2, x, y);
    }
}

// The highlight of smoothness s, 1 in its middle: the paper's own, or a microfacet distribution
// over its value at the normal. (r.v)^e is about (n.h)^(4 e), and cos^e about Beckmann's
// distribution with 2 / alpha^2 = e + 2, so alpha^2 = 1 / (2 e + 1) = (1 - s) / (7 - s) for e = 3 /
// (1 - s).
float straussLobe(Directions d, Strauss p) {
    float rough = 1.0 - p.smoothness;
    float alpha = slopeWidth(sqrt(rough / (6.0 + rough)));
    if (p.lobe == STRAUSS_LOBE_BECKMANN) {
        return PI * alpha * alpha * beckmannDistribution(d.sin2h, d.cos2h, alpha);
    }
    if (p.lobe == STRAUSS_LOBE_GGX) {
        return PI * alpha * alpha * ggxDistribution(d.sin2h, d.cos2h, alpha);
    }
    return powerLobe(p.power, d.versineRv, d.rv, 3.0 / max(rough, 1e-30));
}

// Strauss 1990. The exponent 3 / (1 - s) of a perfect mirror is kept finite at 3e30: the lobe is
// then 1 in the mirror direction and 0 elsewhere, which is its limit.
vec3 strauss(Directions d, Strauss p) {
    float s = p.smoothness;
    float rough3 = (1.0 - s) * (1.0 + s + s * s); // 1 - s^3
    float passed = 1.0 - p.transparency;
    float xl;
    float yl;
    float xv;
    float yv;
    straussArgument(p, d.nl, d.sin2l, xl, yl);
    straussArgument(p, d.nv, d.sin2v, xv, yv);

    float F = straussWeight(xl, yl, p.kf);
    float j = F * straussShadowing(yl, p.ks) * straussShadowing(yv, p.ks);
    float rn = s * s * s * passed;
    float reflected = min(1.0, rn + (rn + p.k) * j);

    // m (1 - F) and the rest of 1: 1 - F has the form of G, so neither is a difference.
    float tinted = p.metalness * straussShadowing(yl, p.kf);
    vec3 highlight = p.specularColor * ((1.0 - p.metalness) + p.metalness * F)
        + p.diffuseColor * tinted;
    float diffuse = d.nl * (1.0 - p.metalness * s) * rough3 * passed;
    bool limits = p.glossMode == STRAUSS_GLOSS_MODE_LIMIT;
    return p.diffuseColor * diffuse
        + glossed(highlight * (straussLobe(d, p) * reflected), p.gloss, limits, 1.0);
}
