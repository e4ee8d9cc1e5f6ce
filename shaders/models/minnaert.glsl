// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// (n.l)^k (n.v)^(k-1) of Minnaert 1941, k - 1 being the power of the product of both cosines, whose
// distance from 1 is known without cancellation. For k < 1 the law has no bound at the rim;
// powNear1() keeps one. 1e-37 keeps a flushed subnormal out of it; k = 1 is Lambert.
float minnaertExact(Directions d, float k) {
    float product = max(d.nl * d.nv, 1e-37);
    float versine = d.versineL + d.nl * (d.sin2v / (1.0 + d.nv));
    return d.nl * powNear1(versine, product, k - 1.0);
}

// An entry is the law times n.v, which has a bound for every k.
vec3 minnaertLawEntry(vec2 u, Minnaert p) {
    return vec3(pow(max(u.x * u.y, 1e-37), p.darkening), 0.0, 0.0);
}

vec3 minnaert(Directions d, Minnaert p) {
    float value = p.law == MINNAERT_LAW_TABLE ? minnaertLaw(vec2(d.nl, d.nv), p).x / max(d.nv, 1e-30)
                                              : minnaertExact(d, p.darkening);
    if (p.normalisation == MINNAERT_NORMALISATION_NORMALISED) {
        value *= 0.5 * (p.darkening + 1.0);
    }
    return p.diffuseColor * value + slotSpecular(d, p.specular);
}
