// SPDX-License-Identifier: MIT-0
// How surfaces reflect light that swings along a line.
#include "lib/incidence.glsl"
#include "lib/math.glsl"
#include "lib/refraction.glsl"

// Rp / Rs of a dielectric, from the incidence of light and eta >= 1, the index beyond the surface
// over that on the light's side: Rp / Rs = ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - s^2, s the
// sine. It has a limit where both vanish: cos^2 of twice the angle for eta = 1.
float dielectricRatio(Incidence i, float eta) {
    float s2 = sin2Incidence(i);
    float cg = i.c * sqrt(max(refractedG2(i, 1.0, eta), 0.0));
    return min(sqr((cg - s2) / max(cg + s2, 1e-30)), 1.0);
}
