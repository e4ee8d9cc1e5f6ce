// SPDX-License-Identifier: MIT-0
// The share that fog leaves. Texels: the eye and the distance, the direction, then the parameters.
vec4 evaluated(int part) {
    FogRay ray;
    ray.eye = caseData(0).xyz;
    ray.range = caseData(0).w;
    ray.direction = caseData(1).xyz;
    return vec4(EVALUATED_BLOCK(ray, unpackEvaluated(2)), 0.0, 0.0, 0.0);
}
