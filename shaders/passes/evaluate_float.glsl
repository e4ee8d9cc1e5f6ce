// SPDX-License-Identifier: MIT-0
// A function of a number. Texels: the number, then the parameters.
vec4 evaluated(int part) {
    return numbersOf(EVALUATED_BLOCK(caseData(0).x, unpackEvaluated(1)), part);
}
