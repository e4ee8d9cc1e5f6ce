// SPDX-License-Identifier: MIT-0
// A model's pi f cos(theta_l). Texels: n, t, l, v, then the parameters. The program defines
// EVALUATED_BLOCK, the model's function, and LIGHT_GATE and VIEW_GATE.
#include "lib/directions.glsl"

// Cut at 0 from below as lights are summed; a NaN stays one.
float cutBelow(float x) {
    return x < 0.0 ? 0.0 : x;
}

vec4 evaluated(int part) {
    vec3 n = safeNormalize(caseData(0).xyz, vec3(0.0, 0.0, 1.0));
    vec3 t = tangentAlong(n, caseData(1).xyz);
    vec3 l = safeNormalize(caseData(2).xyz, n);
    vec3 v = safeNormalize(caseData(3).xyz, n);
    Directions d = directions(n, t, cross(n, t), l, v);
    if ((LIGHT_GATE && !(d.nl > 0.0)) || (VIEW_GATE && !(d.nv > 0.0))) {
        return vec4(0.0);
    }
    vec3 value = EVALUATED_BLOCK(d, unpackEvaluated(4));
    return vec4(cutBelow(value.x), cutBelow(value.y), cutBelow(value.z), 0.0);
}
