// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"

vec3 phongSpecular(Directions d, PhongSpecular p) {
    vec3 lobe = p.specularColor * phongLobe(d.versineRv, d.rv, p.shininess);
    return glossed(lobe, p.gloss, p.glossMode == PHONG_SPECULAR_GLOSS_MODE_LIMIT, 1.0);
}
