// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gaussians.glsl"
#include "lib/gloss.glsl"

// A matte base and the Gaussian lobe of Blinn 1977; reciprocal, the lobe times n.l.
vec3 gaussian(Directions d, Gaussian p) {
    float lobe = gaussianHighlight(p.angle, d, p.width);
    float white = 1.0;
    if (p.highlightForm == GAUSSIAN_HIGHLIGHT_FORM_RECIPROCAL) {
        lobe *= d.nl;
        white = d.nl;
    }
    bool limits = p.glossMode == GAUSSIAN_GLOSS_MODE_LIMIT;
    return p.diffuseColor * d.nl + glossedLobe(p.specularColor, lobe, p.gloss, limits, white);
}
