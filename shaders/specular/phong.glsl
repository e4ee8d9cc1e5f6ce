// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/powers.glsl"

vec3 phongSpecular(Directions d, PhongSpecular p) {
    float power = mirrorPowerLobe(p.power, d, p.shininess);
    bool limits = p.glossMode == PHONG_SPECULAR_GLOSS_MODE_LIMIT;
    return glossed(p.specularColor * power, p.gloss, limits, 1.0);
}
