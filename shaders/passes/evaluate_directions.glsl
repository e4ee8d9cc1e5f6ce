// SPDX-License-Identifier: MIT-0
// A model's pi f cos(theta_l), not cut at 0: who looks for mistakes must see what the model gave,
// and `patina eval` cuts what it answers.
// Texels: n and the x of the pixel, t and its y, l, v, then the parameters. The program defines
// EVALUATED_BLOCK, the model's function, and LIGHT_GATE and VIEW_GATE.
#include "lib/directions.glsl"

// v made unit. What is unit up to the rounding of its own components stays as it is: a division
// would move it by a step of float, which decides where light and viewer nearly oppose.
vec3 givenUnit(vec3 v, vec3 fallback) {
    return abs(dot(v, v) - 1.0) < 2e-7 ? v : safeNormalize(v, fallback);
}

vec4 evaluated(int part) {
    vec3 n = givenUnit(caseData(0).xyz, vec3(0.0, 0.0, 1.0));
    vec3 t = tangentAlong(n, caseData(1).xyz);
    vec3 l = givenUnit(caseData(2).xyz, n);
    vec3 v = givenUnit(caseData(3).xyz, n);
    Directions d = directions(n, t, cross(n, t), l, v);
    d.pixel = vec2(caseData(0).w, caseData(1).w);
    if ((LIGHT_GATE && !(d.nl > 0.0)) || (VIEW_GATE && !(d.nv > 0.0))) {
        return vec4(0.0);
    }
    return numbersOf(EVALUATED_BLOCK(d, unpackEvaluated(4)), part);
}
