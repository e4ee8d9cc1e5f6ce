// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"

// A matte base and the rational lobe of Schlick 1994.
vec3 schlick(Directions d, Schlick p) {
    float lobe = schlickLobe(d.versineRv, d.rv, p.shininess);
    bool limits = p.glossMode == SCHLICK_GLOSS_MODE_LIMIT;
    return p.diffuseColor * d.nl + glossedLobe(p.specularColor, lobe, p.gloss, limits, 1.0);
}
