// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/fresnel.glsl"
#include "lib/microfacet.glsl"

// D in 1/sr, integral of D cos = 1.
float cookTorranceD(Directions d, CookTorrance p) {
    float alpha = slopeWidth(p.roughness);
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_GGX) {
        return ggxD(d.sin2h, d.cos2h, alpha);
    }
    return beckmannD(d.sin2h, d.cos2h, alpha);
}

// s R_s + d R_d of Cook and Torrance 1982, section 3, with R_s = D G F / (4 (n.l)(n.v)). Their print
// has D' = pi D and F D' G / (pi (n.l)(n.v)), which is 4 R_s.
vec3 cookTorrance(Directions d, CookTorrance p) {
    float specularShare = 1.0;
    float diffuseShare = 1.0;
    if (p.balance == COOK_TORRANCE_BALANCE_SPLIT) {
        specularShare = p.specularShare;
        diffuseShare = 1.0 - p.specularShare;
    }
    if (p.scale == COOK_TORRANCE_SCALE_1982) {
        specularShare *= 4.0;
    }
    vec3 F = slotFresnel(halfIncidence(d), p.fresnel);
    float lobe = PI * cookTorranceD(d, p) * vCavityVisibility(d.nl, d.nv, d.nH, d.HH);
    return p.diffuseColor * (diffuseShare * d.nl) + p.specularColor * F * (specularShare * lobe);
}
