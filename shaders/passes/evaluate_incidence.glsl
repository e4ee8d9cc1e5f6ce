// SPDX-License-Identifier: MIT-0
// A Fresnel block's reflectance. Texels: the cosine, then the parameters.
#include "lib/incidence.glsl"

vec4 evaluated(int part) {
    return vec4(EVALUATED_BLOCK(incidenceOf(caseData(0).x), unpackEvaluated(1)), 0.0);
}
