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

// The terms of one direction: F, G with ks, and G with kf, which is 1 - F.
vec3 straussExactTerms(float x, float y, float kf, float ks) {
    return vec3(straussWeight(x, y, kf), straussShadowing(y, ks), straussShadowing(y, kf));
}

// Where the terms change: within q right angles of the horizon, between the widths of F and G.
float straussWarp(float kf, float ks) {
    return 1.2 * sqrt((kf - 1.0) * (ks - 1.0));
}

// The table's axis u = (1 + q) v / (v + q), 0 at the horizon and 1 at the normal, with v = 1 - t
// and t = tan(theta / 2): finest where the terms change, and smooth at both ends, as no function of
// the cosine alone is. 1 - u = q t / (v + q), and F is tabulated as F / (1 - u), which keeps its digits
// at the normal.
vec3 straussTermsEntry(vec2 u, Strauss p) {
    float q = straussWarp(p.kf, p.ks);
    float v = q * u.x / (1.0 + q - u.x);
    float t = (1.0 + q) * (1.0 - u.x) / (1.0 + q - u.x);
    float c = v * (1.0 + t) / (1.0 + t * t);
    float x;
    float y;
    angXY(c, sqr(2.0 * t / (1.0 + t * t)), x, y);
    vec3 exact = straussExactTerms(x, y, p.kf, p.ks);
    float slope = 2.0 * p.kf * sqr((p.kf - 1.0) / p.kf) / (2.0 * p.kf - 1.0); // F / x at 0
    float byT = t > 0.0 ? exact.x / t : slope * 4.0 / PI;
    return vec3(byT * (v + q) / q, exact.y, exact.z);
}

// An even axis, the cosine: the horizon, where G falls within a hundredth, has two entries.
vec3 straussEvenTermsEntry(vec2 u, Strauss p) {
    float x;
    float y;
    angXY(u.x, (1.0 - u.x) * (1.0 + u.x), x, y);
    return straussExactTerms(x, y, p.kf, p.ks);
}

// With v = c (1 + s + c) / ((1 + s) (1 + c)), which is not a difference.
vec3 straussTabledTerms(Strauss p, float c, float s2) {
    float s = sqrt(s2);
    float q = straussWarp(p.kf, p.ks);
    float above = c * (1.0 + s + c);
    float below = q * (1.0 + s);
    float scale = 1.0 / (above + below * (1.0 + c));
    vec3 terms = straussTerms(vec2((1.0 + q) * above * scale, 0.0), p);
    return vec3(terms.x * (below * s * scale), terms.y, terms.z);
}

vec3 straussDirectionTerms(Strauss p, float c, float s2) {
    if (p.argument == STRAUSS_ARGUMENT_ANGLE && p.terms == STRAUSS_TERMS_TABLE) {
        return straussTabledTerms(p, c, s2);
    }
    if (p.argument == STRAUSS_ARGUMENT_ANGLE && p.terms == STRAUSS_TERMS_EVEN_TABLE) {
        return straussEvenTerms(vec2(c, 0.0), p);
    }
    float x;
    float y;
    straussArgument(p, c, s2, x, y);
    return straussExactTerms(x, y, p.kf, p.ks);
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
    return mirrorPowerLobe(p.power, d, 3.0 / max(rough, 1e-30));
}

// The integral of (r.v)^e over all directions is 2 pi / (e + 1): what the highlight is multiplied by
// to reflect its share of an even sky, whose light is pi.
float straussStrength(Strauss p) {
    if (p.normalisation == STRAUSS_NORMALISATION_RAW) {
        return 1.0;
    }
    return 0.5 * (3.0 / max(1.0 - p.smoothness, 1e-30) + 1.0);
}

// Strauss 1990. The exponent 3 / (1 - s) of a perfect mirror is kept finite at 3e30: the lobe is
// then 1 in the mirror direction and 0 elsewhere, which is its limit.
vec3 strauss(Directions d, Strauss p) {
    float s = p.smoothness;
    float rough3 = (1.0 - s) * (1.0 + s + s * s); // 1 - s^3
    float passed = 1.0 - p.transparency;
    vec3 light = straussDirectionTerms(p, d.nl, d.sin2l);
    vec3 viewer = straussDirectionTerms(p, d.nv, d.sin2v);

    float F = light.x;
    float j = F * light.y * viewer.y;
    float rn = s * s * s * passed;
    float reflected = min(1.0, rn + (rn + p.k) * j);

    // m (1 - F) and the rest of 1: 1 - F has the form of G, so neither is a difference.
    float tinted = p.metalness * light.z;
    vec3 highlight = p.specularColor * ((1.0 - p.metalness) + p.metalness * F)
        + p.diffuseColor * tinted;
    float diffuse = d.nl * (1.0 - p.metalness * s) * rough3 * passed;
    bool limits = p.glossMode == STRAUSS_GLOSS_MODE_LIMIT;
    return p.diffuseColor * diffuse
        + glossed(highlight * (straussLobe(d, p) * straussStrength(p) * reflected), p.gloss, limits, 1.0);
}
