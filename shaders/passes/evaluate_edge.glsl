// SPDX-License-Identifier: MIT-0
// How wide the lines of an edge are. Texels: whether the shape turns there, whether it ends, and by
// how much it bends, then the parameters.
#include "lib/edge.glsl"

vec4 evaluated(int part) {
    Edge e;
    e.turns = caseData(0).x > 0.5;
    e.ends = caseData(0).y > 0.5;
    e.bend = caseData(0).z;
    return vec4(EVALUATED_BLOCK(e, unpackEvaluated(1)), 0.0, 0.0);
}
