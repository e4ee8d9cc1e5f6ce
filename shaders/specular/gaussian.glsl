// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/gaussians.glsl"
#include "lib/gloss.glsl"

vec3 gaussianSpecular(Directions d, GaussianSpecular p) {
    vec3 lobe = p.specularColor * gaussianHighlight(p.angle, d, p.width);
    return glossed(lobe, p.gloss, p.glossMode == GAUSSIAN_SPECULAR_GLOSS_MODE_LIMIT, 1.0);
}
