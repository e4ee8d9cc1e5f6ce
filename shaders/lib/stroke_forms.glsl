// SPDX-License-Identifier: MIT-0
// What blocks of kind strokes share.
#include "lib/elementary.glsl"
#include "lib/mark_point.glsl"
#include "lib/math.glsl"

// How far a place is from the middle of its mark, across it: -1 on the left side, 1 on the right.
float asideOf(MarkPoint m) {
    return 2.0 * m.across - 1.0;
}

// How much of a pixel lies on the inner side of an edge that is `inside` away, in half widths.
float inkWithin(MarkPoint m, float inside) {
    return clamp(0.5 + 0.5 * inside / max(m.pixel, 1e-6), 0.0, 1.0);
}

// 0 below `low`, 1 above `high`, which are 0.02 apart or more.
float risingStep(float low, float high, float x) {
    float t = clamp((x - low) / max(high - low, 0.02), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

float between(float a, float b, float t) {
    return a + t * (b - a);
}

// The share of a surface's marks that are kept near silhouettes: all of them up to the cosine `rim`
// between the normal and the viewer, and `inside` of them where the surface faces the viewer.
float shareAtRim(MarkPoint m, float rim, float inside) {
    float away = risingStep(rim, rim + 0.2, dot(m.n, m.v));
    return rim < 1.0 ? between(1.0, inside, away) : 1.0;
}

// The unit direction on the surface nearest to `way`; the tangent where that is the normal.
vec3 alongSurface(MarkPoint m, vec3 way) {
    return unitVector(way - dot(way, m.n) * m.n, m.t);
}

// A direction on the surface, turned about the normal by an angle in radians.
vec3 turnedAlong(MarkPoint m, vec3 along, float angle) {
    return cos(angle) * along + sin(angle) * cross(m.n, along);
}

// A colour that is warmer, or below 0 cooler.
vec3 tinged(vec3 color, float warm) {
    return color * vec3(1.0 + 0.5 * warm, 1.0, 1.0 - 0.7 * warm);
}

// How dark a light is, from 0 at the luminance `light` to 1 at `dark`. ITU-R BT.709.
float darknessOf(vec3 radiance, float dark, float light) {
    float y = 0.2126 * radiance.x + 0.7152 * radiance.y + 0.0722 * radiance.z;
    return clamp((light - y) / max(light - dark, 1e-3), 0.0, 1.0);
}
