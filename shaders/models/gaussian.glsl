// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gaussians.glsl"
#include "lib/gloss.glsl"

// A matte base and the Gaussian lobe of Blinn 1977.
vec3 gaussian(Directions d, Gaussian p) {
    float lobe = gaussianHighlight(p.angle, d, p.width);
    bool limits = p.glossMode == GAUSSIAN_GLOSS_MODE_LIMIT;
    return p.diffuseColor * d.nl + glossedLobe(p.specularColor, lobe, p.gloss, limits, 1.0);
}
