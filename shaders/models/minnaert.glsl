// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

// (n.l)^k (n.v)^(k-1) of Minnaert 1941. The exponent is kept at 120 or less: for k < 1
// the law has no bound at the rim. 1e-37 keeps a flushed subnormal out of log2; k = 1 is Lambert.
vec3 minnaert(Directions d, Minnaert p) {
    float power = (p.darkening - 1.0) * log2(max(d.nl * d.nv, 1e-37));
    float value = d.nl * exp2(min(power, 120.0));
    if (p.normalisation == MINNAERT_NORMALISATION_NORMALISED) {
        value *= 0.5 * (p.darkening + 1.0);
    }
    return p.diffuseColor * value + slotSpecular(d, p.specular);
}
