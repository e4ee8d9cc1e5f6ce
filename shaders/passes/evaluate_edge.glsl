// SPDX-License-Identifier: MIT-0
// A function of an edge. Texels: whether the shape turns there, whether it ends, and by
// how much it bends, then the parameters.
#include "lib/edge.glsl"

vec4 evaluated(int part) {
    Edge e;
    e.turns = caseData(0).x > 0.5;
    e.ends = caseData(0).y > 0.5;
    e.bend = caseData(0).z;
    return numbersOf(EVALUATED_BLOCK(e, unpackEvaluated(1)), part);
}
