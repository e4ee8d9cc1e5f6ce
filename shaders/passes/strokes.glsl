// SPDX-License-Identifier: MIT-0
// Which place of a mark a fragment shows. What lies beside its ink is left out before anything is
// lit.
#include "passes/surface.glsl"
#include "lib/mark_point.glsl"

in vec2 markPlace;
flat in vec4 markRandom;
flat in vec3 markForm;

Strokes strokes;
float markShape;
float markAlpha;

MarkPoint markHere(vec3 light) {
    vec3 n = worldNormal;
    vec3 v = toEye * inversesqrt(max(dot(toEye, toEye), 1e-30));
    vec3 t = safeNormalize(worldTangent - dot(worldTangent, n) * n, anyTangent(n));
    return MarkPoint(markPlace.x, markPlace.y, markForm.x, markForm.y, n, t, v, light, markRandom.w,
        markRandom.x, markRandom.y, markRandom.z);
}

void beginMark(Strokes p) {
    strokes = p;
    markShape = clamp(strokesShape(markHere(vec3(0.0)), p), 0.0, 1.0) * markForm.z;
    if (!(markShape > 0.0)) {
        discard;
    }
}
