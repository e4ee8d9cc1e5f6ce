// SPDX-License-Identifier: MIT-0
#include "lib/interface.glsl"

vec3 facetedBodyIndices(FacetedBodyRefraction p) {
    return dispersedIndices(p.index, p.dispersion);
}

// Snell's law for one channel, into the body and out of it.
vec3 facetedBodyRefraction(Interface c, FacetedBodyRefraction p) {
    return crossedDirection(c, facetedBodyIndices(p));
}

// Fresnel's reflectance of each surface that a ray meets.
float facetedBodyRefractionMirrored(Interface c, FacetedBodyRefraction p) {
    return crossedReflectance(c, facetedBodyIndices(p));
}

vec3 facetedBodyRefractionLeft(float way, FacetedBodyRefraction p) {
    return p.tint * leftAfter(way, p.absorptionColor, p.absorptionDistance);
}
