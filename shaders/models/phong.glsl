// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// The lobe (r.v)^e of Phong 1975; normalised, pi (n.l) (e + 2) / (2 pi) (r.v)^e of Lewis 1994.
vec3 phong(Directions d, Phong p) {
    float lobe = pow1m(d.versineRv, d.rv, p.shininess);
    if (p.normalisation == PHONG_NORMALISATION_NORMALISED) {
        lobe *= 0.5 * (p.shininess + 2.0) * d.nl;
    }
    return p.diffuseColor * d.nl + p.specularColor * lobe;
}
