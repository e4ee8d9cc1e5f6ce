// SPDX-License-Identifier: MIT-0
// A function of a surface among others. Texels: its depth and its opacity, then the parameters.
#include "lib/layer.glsl"

vec4 evaluated(int part) {
    Layer l;
    l.depth = caseData(0).x;
    l.opacity = caseData(0).y;
    return numbersOf(EVALUATED_BLOCK(l, unpackEvaluated(1)), part);
}
