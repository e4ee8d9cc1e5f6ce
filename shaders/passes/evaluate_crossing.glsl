// SPDX-License-Identifier: MIT-0
// A function of a ray at a surface. Texels: where it comes from, the normal, the channel and
// whether it leaves the body, one number after the other, then the parameters.
#include "lib/crossing.glsl"

vec4 evaluated(int part) {
    Crossing c;
    c.l = caseData(0).xyz;
    c.n = vec3(caseData(0).w, caseData(1).x, caseData(1).y);
    c.channel = int(caseData(1).z);
    c.leaves = caseData(1).w > 0.5;
    return numbersOf(EVALUATED_BLOCK(c, unpackEvaluated(2)), part);
}
