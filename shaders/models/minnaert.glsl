// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// (n.l)^k (n.v)^(k-1) of Minnaert 1941, k - 1 being the power of the product of both cosines, whose
// distance from 1 is known without cancellation. For k < 1 the law has no bound at the rim;
// powNear1() keeps one. 1e-37 keeps a flushed subnormal out of it; k = 1 is Lambert.
vec3 minnaert(Directions d, Minnaert p) {
    float product = max(d.nl * d.nv, 1e-37);
    float versine = d.versineL + d.nl * (d.sin2v / (1.0 + d.nv));
    float value = d.nl * powNear1(versine, product, p.darkening - 1.0);
    if (p.normalisation == MINNAERT_NORMALISATION_NORMALISED) {
        value *= 0.5 * (p.darkening + 1.0);
    }
    return p.diffuseColor * value + slotSpecular(d, p.specular);
}
