// SPDX-License-Identifier: MIT-0
// The share that fog leaves. Texels: the distance, then the parameters.
vec4 evaluated(int part) {
    return vec4(EVALUATED_BLOCK(caseData(0).x, unpackEvaluated(1)), 0.0, 0.0, 0.0);
}
