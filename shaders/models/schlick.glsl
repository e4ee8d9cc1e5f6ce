// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"

// A matte base and the rational lobe of Schlick 1994; reciprocal, the lobe times n.l.
vec3 schlick(Directions d, Schlick p) {
    float lobe = schlickLobe(d.versineRv, d.rv, p.shininess);
    float white = 1.0;
    if (p.highlightForm == SCHLICK_HIGHLIGHT_FORM_RECIPROCAL) {
        lobe *= d.nl;
        white = d.nl;
    }
    bool limits = p.glossMode == SCHLICK_GLOSS_MODE_LIMIT;
    return p.diffuseColor * d.nl + glossedLobe(p.specularColor, lobe, p.gloss, limits, white);
}
