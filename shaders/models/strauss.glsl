// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/fresnel.glsl"

// The argument x of Strauss's F and G, 0 at the normal and 1 at the horizon, and y = 1 - x. It is
// the angle in right angles: with it F(0) = 0 and G(0) = 1, as the paper requires.
void straussArgument(Strauss p, float c, float s2, OUT(float) x, OUT(float) y) {
    if (p.argument == STRAUSS_ARGUMENT_COSINE) {
        x = c;
        y = s2 / (1.0 + c);
    } else {
        angXY(c, s2, x, y);
    }
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
    float lobe = pow1m(d.versineRv, d.rv, 3.0 / max(1.0 - s, 1e-30));

    vec3 highlight = mix(p.specularColor, p.diffuseColor, p.metalness * (1.0 - F));
    float diffuse = d.nl * (1.0 - p.metalness * s) * rough3 * passed;
    return p.diffuseColor * diffuse + highlight * (lobe * reflected);
}
