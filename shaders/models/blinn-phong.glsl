// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"
#include "lib/powers.glsl"

// The lobe (n.h)^e of Blinn 1977, 0 behind the surface as the function `lit` of Cg and HLSL has it,
// or the power alone, which a light behind the surface can still set off.
vec3 blinnPhong(Directions d, BlinnPhong p) {
    float nl = max(d.nl, 0.0);
    float lobe = halfPowerLobe(p.power, d, p.shininess);
    if (p.gating == BLINN_PHONG_GATING_LIT && !(d.nl > 0.0)) {
        lobe = 0.0;
    }
    float white = 1.0;
    if (p.normalisation == BLINN_PHONG_NORMALISATION_NORMALISED) {
        lobe *= blinnNormalisation(p.shininess) * nl;
        white = nl;
    }
    bool limits = p.glossMode == BLINN_PHONG_GLOSS_MODE_LIMIT;
    return p.diffuseColor * nl + glossedLobe(p.specularColor, lobe, p.gloss, limits, white);
}
