// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/powers.glsl"

vec3 blinnPhongSpecular(Directions d, BlinnPhongSpecular p) {
    vec3 lobe = p.specularColor * halfPowerLobe(p.power, d, p.shininess);
    return glossed(lobe, p.gloss, p.glossMode == BLINN_PHONG_SPECULAR_GLOSS_MODE_LIMIT, 1.0);
}
