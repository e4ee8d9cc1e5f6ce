// SPDX-License-Identifier: MIT-0
// A function of an incidence. Texels: the cosine, then the parameters.
#include "lib/incidence.glsl"

vec4 evaluated(int part) {
    return numbersOf(EVALUATED_BLOCK(incidenceOf(caseData(0).x), unpackEvaluated(1)), part);
}
