// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"
#include "lib/powers.glsl"

// The lobe (r.v)^e of Phong 1975; normalised, pi (n.l) (e + 2) / (2 pi) (r.v)^e of Lewis 1994.
vec3 phong(Directions d, Phong p) {
    float lobe = mirrorPowerLobe(p.power, d, p.shininess);
    float white = 1.0;
    if (p.normalisation == PHONG_NORMALISATION_NORMALISED) {
        lobe *= phongNormalisation(p.shininess) * d.nl;
        white = d.nl;
    }
    bool limits = p.glossMode == PHONG_GLOSS_MODE_LIMIT;
    return p.diffuseColor * d.nl + glossedLobe(p.specularColor, lobe, p.gloss, limits, white);
}
