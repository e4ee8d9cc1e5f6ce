// SPDX-License-Identifier: MIT-0
#include "lib/cheap_microfacet.glsl"
#include "lib/directions.glsl"
#include "lib/incidence.glsl"
#include "lib/masking.glsl"
#include "lib/math.glsl"
#include "lib/microfacet.glsl"
#include "lib/powers.glsl"

// D in 1/sr, integral of D cos = 1.
float metallicRoughnessDistribution(Directions d, MetallicRoughness p) {
    return ggxDistribution(d.sin2h, d.cos2h, slopeWidth(p.roughness));
}

// G / (4 n.v). "None" is G = (n.l)(n.v), which leaves nothing of the term.
float metallicRoughnessVisibility(Directions d, MetallicRoughness p) {
    float alpha = slopeWidth(p.roughness);
    if (p.masking == METALLIC_ROUGHNESS_MASKING_NONE) {
        return 0.25 * d.nl;
    }
    if (p.masking == METALLIC_ROUGHNESS_MASKING_HAMMON) {
        return hammonVisibility(d.nl, d.nv, alpha);
    }
    return correlatedVisibility(d.nl, d.nv, ggxUnmasked(d.nl, d.sin2l, alpha),
        ggxUnmasked(d.nv, d.sin2v, alpha));
}

// G, for plots of the masking alone.
float metallicRoughnessMasking(Directions d, MetallicRoughness p) {
    return 4.0 * d.nv * metallicRoughnessVisibility(d, p);
}

// The mix of glTF 2.0, appendix B, by the metalness m: both surfaces have the same mirrors, so that
// their reflectances at the half vector are mixed, (1 - m) F(f0) + m F(base) with Schlick's
// F(a) = a + (1 - a) (1 - h.l)^5. The matte base gets 1 - max F(f0), which is (1 - max f0)
// (1 - (1 - h.l)^5), as in KHR_materials_specular.
vec3 metallicRoughness(Directions d, MetallicRoughness p) {
    Incidence mirror = halfIncidence(d);
    float rise = pow5(mirror.versine);
    vec3 facing = p.f0 * (1.0 - p.metalness) + p.diffuseColor * p.metalness;
    vec3 F = facing + (vec3(1.0) - facing) * rise;
    float passed = (1.0 - max(p.f0.x, max(p.f0.y, p.f0.z))) * fifthRise(mirror.c);
    float lobe = PI * metallicRoughnessDistribution(d, p) * metallicRoughnessVisibility(d, p);
    return p.diffuseColor * ((1.0 - p.metalness) * passed * d.nl) + F * lobe;
}
