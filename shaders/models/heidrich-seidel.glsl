// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/gloss.glsl"
#include "lib/powers.glsl"

// Thin parallel fibres along the grain t: of all normals across a fibre the one that lies nearest
// to the light, or to the mirror direction, decides (Heidrich and Seidel 1998, section 3):
//   n.l -> sqrt(1 - (l.t)^2)     r.v -> sqrt(1 - (l.t)^2) sqrt(1 - (v.t)^2) - (l.t)(v.t)
// The roots are the lengths across t, sl^2 = (l.n)^2 + (l.b)^2, and 1 - r.v is half the squared
// distance of (sl, -l.t) and (sv, v.t), so neither cancels.
vec3 heidrichSeidel(Directions d, HeidrichSeidel p) {
    Directions g = alongGrain(d, p.tangentAngle);
    float sl = sqrt(d.nl * d.nl + g.lb * g.lb);
    float sv = sqrt(d.nv * d.nv + g.vb * g.vb);
    float versine = 0.5 * (sqr(sl - sv) + sqr(g.tH));
    float lobe = powerLobe(p.power, versine, sl * sv - g.lt * g.vt, p.shininess);
    bool limits = p.glossMode == HEIDRICH_SEIDEL_GLOSS_MODE_LIMIT;
    vec3 value = p.diffuseColor * sl + glossed(p.specularColor * lobe, p.gloss, limits, 1.0);
    return p.selfShadowing ? d.nl * value : value;
}
