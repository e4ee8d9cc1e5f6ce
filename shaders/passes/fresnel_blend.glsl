// SPDX-License-Identifier: MIT-0
#include "lib/incidence.glsl"

// Towards the tint by the reflectance for the viewer's own direction.
vec3 fresnelBlended(Surface s, vec3 shaded, Blend p) {
    return mix(shaded, blendTint(p), blendShare(incidenceBetween(s.n, s.v), p));
}
