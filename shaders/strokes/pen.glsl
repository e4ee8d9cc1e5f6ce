// SPDX-License-Identifier: MIT-0
#include "lib/stroke_forms.glsl"

// The directions of hatching: 0, across it from a middle tone on, and between them in the dark.
float penLayer(MarkPoint m) {
    return m.phase < 0.5 ? 0.0 : m.phase < 0.8 ? 1.0 : 2.0;
}

float penFacing(MarkPoint m) {
    return clamp(dot(m.n, m.v), 0.0, 1.0);
}

float penStrokesShare(MarkPoint m, PenStrokes p) {
    return shareAtRim(m, p.rim, 0.0) * risingStep(0.0, 0.15, penFacing(m)) * penFacing(m);
}

vec2 penStrokesSize(MarkPoint m, PenStrokes p) {
    float bow = 1.0 + 16.0 * abs(p.bow);
    return vec2(p.strokeLength * (1.0 - p.variation * m.size), p.penWidth * bow);
}

vec3 penStrokesAlong(MarkPoint m, PenStrokes p) {
    vec3 along = m.t;
    if (p.direction == PEN_STROKES_DIRECTION_AROUND) {
        along = alongSurface(m, cross(m.n, m.v));
    } else if (p.direction == PEN_STROKES_DIRECTION_DOWN) {
        along = alongSurface(m, vec3(0.0, -1.0, 0.0));
    }
    float layer = penLayer(m);
    float crossed = layer * (layer > 1.5 ? 0.25 : 1.0) * p.angleCross;
    return turnedAlong(m, along, p.angle + crossed + PI * p.unrest * (m.shade - 0.5));
}

// How far inside the line of a share of its full width a place is, in half widths of the mark. The
// pen presses in the middle of its way.
float withinPen(MarkPoint m, PenStrokes p, float share) {
    float bow = 1.0 + 16.0 * abs(p.bow);
    float x = 2.0 * m.along - 1.0;
    float middle = (p.bow < 0.0 ? -1.0 : 1.0) * (1.0 - 1.0 / bow) * (1.0 - 2.0 * x * x);
    float wide = share * sqrt(max(1.0 - x * x, 0.0)) / bow;
    return wide - abs(asideOf(m) - middle);
}

float penStrokesShape(MarkPoint m, PenStrokes p) {
    float ends = 2.0 * m.aspect * min(m.along, 1.0 - m.along);
    return inkWithin(m, withinPen(m, p, 1.0)) * inkWithin(m, ends);
}

// How far a stroke has come in as the surface gets darker.
float penShown(MarkPoint m, PenStrokes p, float dark) {
    float begin = 0.3 * penLayer(m);
    float own = clamp((dark - begin) / (1.0 - begin), 0.0, 1.0);
    float place = m.order / max(penFacing(m), 0.05);
    return clamp((own - place) / 0.12, 0.0, 1.0);
}

float penStrokesOpacity(MarkPoint m, PenStrokes p) {
    float dark = darknessOf(m.radiance, p.toneDark, p.toneLight);
    float shown = penShown(m, p, dark);
    float share = between(0.4, 1.0, shown) * between(1.0, 0.5 + 0.5 * dark, p.pressure);
    float ink = inkWithin(m, withinPen(m, p, share)) * min(3.0 * shown, 1.0);
    return shown > 0.0 ? ink * p.opacity : 0.0;
}

vec3 penStrokes(MarkPoint m, PenStrokes p) {
    return lerp(p.inkColor, m.radiance, p.tint);
}

vec3 penStrokesUnder(MarkPoint m, PenStrokes p) {
    return lerp(p.paperColor, m.radiance, p.wash);
}
