// SPDX-License-Identifier: MIT-0
#include "lib/drawn_place.glsl"

// One layer of lines that swell with the tone: where planes across `way` cut the surface, between
// one and two spacings apart, with new ones that grow between them as it comes nearer. All of them
// together cover the share tone.x and leave tone.y.
vec2 engravedLayer(DrawnPlace at, vec3 way, vec2 tone, Engraving p) {
    float passed = passedByPixel(at, way);
    DrawnScale s = drawnScale(passed * max(p.spacing, 2.0));
    vec3 across = anyTangent(way);
    float row = dot(at.x, way) * s.cells + 0.3 * p.wobble * drawnWave(dot(at.x, across), s);
    float size = 1.0 / (passed * s.cells);
    float grown = s.next * s.next * (3.0 - 2.0 * s.next);
    float width = tone.x * size / (1.0 + grown);
    float clear = clearOfPlanes(at, way);
    float shown = clamp(2.0 * width, 0.0, 1.0) * clear;
    vec2 drawn = lineMark(width, size * offClass(row, 0.0));
    drawn = overInk(drawn, lineMark(width * grown, size * offClass(row, 1.0)));
    return clearMarks(faded(drawn, shown, 1.0 - shown), drawnClear(at, s), tone);
}

// How much darker than the tone `from` it is, 1 at the darkest.
float darkerThan(float from, float dark) {
    return clamp((dark - from) / max(1.0 - from, 0.05), 0.0, 1.0);
}

// Up to three layers of lines that follow the form: the first in all tones, the second across it
// from a middle tone on, the third in the dark. What the earlier ones leave of a tone is shared by
// those that are there.
vec3 engraving(Directions d, Engraving p) {
    DrawnPlace at = drawnAt(p.place, p.placeNormal, p.placeView, p.placePixel);
    vec2 tone = tones(d, p.toneDark, p.toneLight);
    float dark = tone.x;
    float layers = float(p.layers);
    float second = layers > 1.5 ? darkerThan(p.crossFrom, dark) : 0.0;
    float third = layers > 2.5 ? darkerThan(p.thirdFrom, dark) : 0.0;
    vec3 way = unitVector(p.lineDirection, vec3(0.0, 1.0, 0.0));
    vec3 other = unitVector(p.crossDirection, vec3(1.0, 0.0, 0.0));
    vec3 last = unitVector(cross(way, other), vec3(0.0, 0.0, 1.0));
    vec2 drawn = engravedLayer(at, way, faded(tone, p.swell, 1.0 - p.swell), p);
    second = 0.8 * p.swell * second;
    third = 0.7 * p.swell * third;
    drawn = overInk(drawn, engravedLayer(at, other, vec2(second, 1.0 - second), p));
    drawn = overInk(drawn, engravedLayer(at, last, vec2(third, 1.0 - third), p));
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
