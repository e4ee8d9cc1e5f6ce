// SPDX-License-Identifier: MIT-0
// A function of a point. Texels: the point, then the parameters.
vec4 evaluated(int part) {
    return numbersOf(EVALUATED_BLOCK(caseData(0).xyz, unpackEvaluated(1)), part);
}
