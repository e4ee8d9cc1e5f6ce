// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"

vec3 schlickSpecular(Directions d, SchlickSpecular p) {
    vec3 lobe = p.specularColor * schlickLobe(d.versineRv, d.rv, p.shininess);
    float white = 1.0;
    if (p.highlightForm == SCHLICK_SPECULAR_HIGHLIGHT_FORM_RECIPROCAL) {
        lobe *= d.nl;
        white = d.nl;
    }
    return glossed(lobe, p.gloss, p.glossMode == SCHLICK_SPECULAR_GLOSS_MODE_LIMIT, white);
}
