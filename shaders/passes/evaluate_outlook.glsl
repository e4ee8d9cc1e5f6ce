// SPDX-License-Identifier: MIT-0
// A function of where one looks. Texels: the direction and the picture's colour, one number after the
// other, then the parameters.
#include "lib/outlook.glsl"

vec4 evaluated(int part) {
    Outlook o;
    o.d = caseData(0).xyz;
    o.picture = vec3(caseData(0).w, caseData(1).x, caseData(1).y);
    return numbersOf(EVALUATED_BLOCK(o, unpackEvaluated(2)), part);
}
