// SPDX-License-Identifier: MIT-0
// A light's direction and its radiance, one pixel each. Texels: the point, then the parameters.
#include "lib/illumination.glsl"

vec4 evaluated(int part) {
    Illumination i = EVALUATED_BLOCK(caseData(0).xyz, unpackEvaluated(1));
    return vec4(part == 0 ? i.l : i.radiance, 0.0);
}
