// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// pi times the factor that makes the integral of (n.h)^e (n.l) one at normal incidence,
//   (e + 2)(e + 4) / (8 (2^(-e/2) + e)).
// Exact; the common (e + 8)/8 is up to 7.5 % above it (near e = 8). e >= 0.
float blinnNormalisation(float e) {
    return (e + 2.0) * (e + 4.0) / (8.0 * (exp2(-0.5 * e) + e));
}

// The lobe (n.h)^e of Blinn 1977.
vec3 blinnPhong(Directions d, BlinnPhong p) {
    float lobe = powSC(d.sin2h, d.cos2h, p.shininess);
    if (!(d.nH > 0.0)) {
        lobe = 0.0; // the viewer is further below the horizon than the light is above it
    }
    if (p.normalisation == BLINN_PHONG_NORMALISATION_NORMALISED) {
        lobe *= blinnNormalisation(p.shininess) * d.nl;
    }
    return p.diffuseColor * d.nl + p.specularColor * lobe;
}
