// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gaussians.glsl"
#include "lib/gloss.glsl"

vec3 gaussianSpecular(Directions d, GaussianSpecular p) {
    vec3 lobe = p.specularColor * gaussianHighlight(p.angle, d, p.width);
    float white = 1.0;
    if (p.highlightForm == GAUSSIAN_SPECULAR_HIGHLIGHT_FORM_RECIPROCAL) {
        lobe *= d.nl;
        white = d.nl;
    }
    return glossed(lobe, p.gloss, p.glossMode == GAUSSIAN_SPECULAR_GLOSS_MODE_LIMIT, white);
}
