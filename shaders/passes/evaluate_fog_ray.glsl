// SPDX-License-Identifier: MIT-0
// A function of the way through fog. Texels: the eye and the distance, the direction, then the
// parameters.
vec4 evaluated(int part) {
    FogRay ray;
    ray.eye = caseData(0).xyz;
    ray.range = caseData(0).w;
    ray.direction = caseData(1).xyz;
    return numbersOf(EVALUATED_BLOCK(ray, unpackEvaluated(2)), part);
}
