// SPDX-License-Identifier: MIT-0
// A function of the block's values alone. Texels: the parameters.
vec4 evaluated(int part) {
    return numbersOf(EVALUATED_BLOCK(unpackEvaluated(0)), part);
}
