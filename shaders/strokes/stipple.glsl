// SPDX-License-Identifier: MIT-0
#include "lib/stroke_forms.glsl"

// As many dots on a square of the picture, whichever way the surface faces.
float stippleFacing(MarkPoint m) {
    return clamp(dot(m.n, m.v), 0.0, 1.0);
}

float stippleStrokesShare(MarkPoint m, StippleStrokes p) {
    return shareAtRim(m, p.rim, 0.0) * stippleFacing(m);
}

vec2 stippleStrokesSize(MarkPoint m, StippleStrokes p) {
    float own = 1.0 - p.variation * m.size;
    return vec2(p.dotLength * own, p.dotWidth * own);
}

vec3 stippleStrokesAlong(MarkPoint m, StippleStrokes p) {
    return turnedAlong(m, m.t, p.angle);
}

// How far inside the dot a place is, in half widths, when the dot has a share of its full radius.
float withinDot(MarkPoint m, float share) {
    float along = (2.0 * m.along - 1.0);
    float aside = asideOf(m);
    return share - sqrt(along * along + aside * aside);
}

float stippleStrokesShape(MarkPoint m, StippleStrokes p) {
    return inkWithin(m, withinDot(m, 1.0));
}

// Dots come one after the other as the surface gets darker, each small at first.
float stippleStrokesOpacity(MarkPoint m, StippleStrokes p) {
    float dark = darknessOf(m.radiance, p.toneDark, p.toneLight);
    float place = m.order / max(stippleFacing(m), 0.02);
    float grown = clamp((dark - place) / 0.15, 0.0, 1.0);
    float share = between(0.45, 1.0, grown) * between(1.0, 0.7 + 0.6 * dark, p.weight);
    return grown > 0.0 ? inkWithin(m, withinDot(m, min(share, 1.0))) * min(3.0 * grown, 1.0) : 0.0;
}

vec3 stippleStrokes(MarkPoint m, StippleStrokes p) {
    return tinged(lerp(p.inkColor, m.radiance, p.tint), p.hueVariation * (2.0 * m.shade - 1.0));
}

vec3 stippleStrokesUnder(MarkPoint m, StippleStrokes p) {
    return lerp(p.paperColor, m.radiance, p.wash);
}
