// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"

vec3 schlickSpecular(Directions d, SchlickSpecular p) {
    vec3 lobe = p.specularColor * schlickLobe(d.versineRv, d.rv, p.shininess);
    return glossed(lobe, p.gloss, p.glossMode == SCHLICK_SPECULAR_GLOSS_MODE_LIMIT, 1.0);
}
