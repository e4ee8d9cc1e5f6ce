// SPDX-License-Identifier: MIT-0
// How much a surface among others counts. Texels: its depth and its opacity, then the parameters.
#include "lib/layer.glsl"

vec4 evaluated(int part) {
    Layer l;
    l.depth = caseData(0).x;
    l.opacity = caseData(0).y;
    return vec4(EVALUATED_BLOCK(l, unpackEvaluated(1)), 0.0, 0.0, 0.0);
}
