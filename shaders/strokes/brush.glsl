// SPDX-License-Identifier: MIT-0
#include "lib/stroke_forms.glsl"

float brushStrokesShare(MarkPoint m, BrushStrokes p) {
    float facing = dot(m.n, m.v);
    float even = clamp(0.3 + facing, 0.0, 1.0);
    return shareAtRim(m, p.rim, 0.0) * risingStep(-0.02, 0.25, facing) * even;
}

vec2 brushStrokesSize(MarkPoint m, BrushStrokes p) {
    float own = 1.0 - p.variation * m.size;
    return vec2(p.strokeLength * own, p.weight * (1.0 - 0.7 * p.variation * m.shade));
}

vec3 brushStrokesAlong(MarkPoint m, BrushStrokes p) {
    vec3 along = m.t;
    if (p.direction == BRUSH_STROKES_DIRECTION_AROUND) {
        along = alongSurface(m, cross(m.n, m.v));
    } else if (p.direction == BRUSH_STROKES_DIRECTION_DOWN) {
        along = alongSurface(m, vec3(0.0, -1.0, 0.0));
    }
    return turnedAlong(m, along, p.angle + PI * p.unrest * (m.phase - 0.5));
}

// One wave of bristles, so many to the width of the brush. Where they are finer than pixels they
// have no height.
float bristleWave(MarkPoint m, float count, float shift) {
    float pixels = 1.0 / max(m.pixel * count, 1e-6);
    float height = clamp(0.5 * pixels - 0.5, 0.0, 1.0);
    float drift = 0.12 * sin(2.0 * PI * (1.3 * m.along + m.phase));
    return height * sin(2.0 * PI * (count * (m.across + drift / count) + shift));
}

// How much paint the bristles carry across the stroke, around 0.5.
float bristlesAt(MarkPoint m, BrushStrokes p) {
    float n = p.bristles;
    return 0.5 + 0.2 * bristleWave(m, n, 7.0 * m.phase) +
        0.17 * bristleWave(m, 0.43 * n, 3.0 * m.size) +
        0.13 * bristleWave(m, 1.87 * n, 5.0 * m.shade);
}

// A stroke begins round where the brush is set down, over the length of the attack, and thins out
// where its paint ends.
float brushWidth(MarkPoint m, BrushStrokes p) {
    float begin = 0.04 + 0.5 * p.attack;
    float end = 0.06 + 0.8 * p.attenuation;
    float rise = clamp(m.along / begin, 0.0, 1.0);
    float fall = clamp((1.0 - m.along) / end, 0.0, 1.0);
    return sqrt(rise * (2.0 - rise)) * sqrt(fall * (2.0 - fall));
}

float brushStrokesShape(MarkPoint m, BrushStrokes p) {
    float waves = 0.05 * sin(2.0 * PI * (2.1 * m.along + m.shade)) +
        0.03 * sin(2.0 * PI * (5.3 * m.along + m.size));
    float inside = (1.0 - 0.08 + waves) * brushWidth(m, p) - abs(asideOf(m));
    float ends = inkWithin(m, m.aspect * 2.0 * min(m.along, 1.0 - m.along));
    float dry = (1.0 - p.loading) + p.attenuation * m.along * m.along * (1.0 - 0.5 * p.loading);
    float paint = clamp(0.5 + 4.0 * (bristlesAt(m, p) - 0.85 * dry), 0.0, 1.0);
    return min(inkWithin(m, inside), ends) * paint;
}

float brushStrokesOpacity(MarkPoint m, BrushStrokes p) {
    return p.opacity;
}

// The light of the surface, a little lighter or darker, warmer or cooler from stroke to stroke, and
// furrowed by the bristles.
vec3 brushStrokes(MarkPoint m, BrushStrokes p) {
    float tone = 1.0 + p.toneVariation * (2.0 * m.shade - 1.0);
    float warm = p.hueVariation * (2.0 * m.size - 1.0);
    float furrow = 1.0 + 1.5 * p.relief * (bristlesAt(m, p) - 0.5);
    return tinged(m.radiance * (tone * furrow), warm);
}

vec3 brushStrokesUnder(MarkPoint m, BrushStrokes p) {
    return lerp(m.radiance, p.groundColor, p.ground);
}
