// SPDX-License-Identifier: MIT-0
#include "lib/stroke_forms.glsl"

// Marks just behind the silhouette show their tips.
float graftalStrokesShare(MarkPoint m, GraftalStrokes p) {
    return shareAtRim(m, p.rim, p.inside) * risingStep(-0.4, -0.2, dot(m.n, m.v));
}

// A mark stands on the middle of its rectangle, of which it takes the upper half.
vec2 graftalStrokesSize(MarkPoint m, GraftalStrokes p) {
    float own = 1.0 - p.variation * m.size;
    return vec2(2.0 * p.tuftLength * own, p.tuftWidth * sqrt(own));
}

vec3 graftalStrokesAlong(MarkPoint m, GraftalStrokes p) {
    vec3 side = cross(m.n, m.t);
    vec3 lean = (m.phase - 0.5) * m.t + (m.shade - 0.5) * side;
    return unitVector(m.n + p.droop * vec3(0.0, -1.0, 0.0) + 2.0 * p.unrest * lean, m.n);
}

// How far inside a blade of half width `wide` at its root a place is, h of its length up; its tip
// ends `bend` aside.
float withinBlade(float h, float aside, float wide, float bend) {
    float left = clamp(1.0 - h, 0.0, 1.0);
    return wide * sqrt(left) * (0.35 + 0.65 * left) - abs(aside - bend * h * h);
}

float withinLeaf(float h, float aside) {
    float s = clamp((h - 0.12) / 0.88, 0.0, 1.0);
    float leaf = 0.92 * sqrt(s * (1.0 - s)) * (2.0 - 0.9 * s) - abs(aside);
    float stem = h < 0.5 ? 0.12 - abs(aside) : -1.0;
    return max(leaf, stem);
}

float withinTuft(float h, float aside, float lean) {
    float middle = withinBlade(h, aside, 0.34, lean);
    float left = withinBlade(h / 0.82, aside + 0.22 + 0.15 * h, 0.26, lean - 0.32);
    float right = withinBlade(h / 0.9, aside - 0.24 - 0.1 * h, 0.26, lean + 0.34);
    return max(middle, max(left, right));
}

// How far inside its outline a place of the mark is, in half widths.
float withinGraftal(MarkPoint m, GraftalStrokes p) {
    float h = 2.0 * m.along - 1.0;
    float aside = asideOf(m);
    float lean = 0.5 * (m.phase - 0.5);
    float within = withinBlade(h, aside, 0.5, lean);
    if (p.form == GRAFTAL_STROKES_FORM_LEAF) {
        within = withinLeaf(h, aside);
    } else if (p.form == GRAFTAL_STROKES_FORM_TUFT) {
        within = withinTuft(h, aside, lean);
    }
    return within;
}

// Towards its root a mark goes over into the surface.
float graftalStrokesShape(MarkPoint m, GraftalStrokes p) {
    return inkWithin(m, withinGraftal(m, p)) * risingStep(0.0, 0.18, 2.0 * m.along - 1.0);
}

float graftalStrokesOpacity(MarkPoint m, GraftalStrokes p) {
    return 1.0;
}

// The light of the surface in flat tones, between dark lines.
vec3 graftalStrokes(MarkPoint m, GraftalStrokes p) {
    float h = clamp(2.0 * m.along - 1.0, 0.0, 1.0);
    float tone = (1.0 + p.toneVariation * (2.0 * m.shade - 1.0)) *
        between(p.rootTone, 1.0, h);
    vec3 fill = lerp(m.radiance, p.fillColor, p.fill) * tone;
    float line = 2.0 * p.lineWidth / max(graftalStrokesSize(m, p).y, 1e-3);
    float lined = p.lineWidth > 0.0 ? 1.0 - inkWithin(m, withinGraftal(m, p) - line) : 0.0;
    return lerp(fill, p.inkColor, lined);
}

vec3 graftalStrokesUnder(MarkPoint m, GraftalStrokes p) {
    return m.radiance;
}
