// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/marks.glsl"

// How far a place is from stroke number `stroke`, in spacings, which bends by up to `wobble` of a
// spacing in a rhythm of its own. `rows` counts spacings across the strokes, `along` their rhythm.
float besideStroke(float rows, float along, float stroke, float wobble) {
    float rhythm = along + 0.381966 * stroke;
    // To the nearest whole number: a phase just below one keeps its digits.
    float bend = wobble * 0.5 * sin(2.0 * PI * (rhythm - floor(rhythm + 0.5)));
    return abs(rows - stroke + bend);
}

// Strokes along x, `spacing` apart, the first one `shift` spacings from 0. A place belongs to the
// nearer of the two strokes that it lies between, wherever they bend to.
vec2 hatchingStrokes(vec2 place, float spacing, float shift, float width, float wobble) {
    float rows = place.y / spacing - shift;
    float along = place.x / (9.0 * spacing);
    float stroke = floor(rows);
    float aside = min(besideStroke(rows, along, stroke, wobble),
        besideStroke(rows, along, stroke + 1.0, wobble));
    // A pen does not fill the gap between its strokes.
    return lineMark(min(width, 0.75 * spacing), aside * spacing);
}

// Layer `layer` of strokes over what is drawn already: all its ink is there from the tone
// (layer + 1) / 6 on.
vec2 hatchingLayer(vec2 drawn, float dark, float layer, vec2 stroke) {
    float share = clamp(6.0 * dark - layer, 0.0, 1.0);
    float missing = clamp(layer + 1.0 - 6.0 * dark, 0.0, 1.0);
    vec2 added = faded(stroke, share, missing);
    return vec2(drawn.x + drawn.y * added.x, drawn.y * added.y);
}

// Six tones of strokes, each of which keeps the strokes of the lighter ones: wide apart, between
// them, then across, then both at half the spacing. E. Praun, H. Hoppe, M. Webb and A. Finkelstein,
// Real-Time Hatching, SIGGRAPH 2001, blend six tones of nested strokes in the same way.
vec3 hatching(Directions d, Hatching p) {
    float dark = hatchingToneCurve(tones(d, p.toneDark, p.toneLight).x, p);
    float apart = max(p.spacing, 2.0);
    float close = 0.5 * apart;
    float pen = p.penWidth;
    vec2 along = turnedPlace(d.pixel, p.angle);
    vec2 across = turnedPlace(d.pixel, p.angle + p.angleCross);
    vec2 drawn = vec2(0.0, 1.0);
    drawn = hatchingLayer(drawn, dark, 0.0, hatchingStrokes(along, apart, 0.0, pen, p.wobble));
    drawn = hatchingLayer(drawn, dark, 1.0, hatchingStrokes(along, apart, 0.5, pen, p.wobble));
    drawn = hatchingLayer(drawn, dark, 2.0, hatchingStrokes(across, apart, 0.0, pen, p.wobble));
    drawn = hatchingLayer(drawn, dark, 3.0, hatchingStrokes(across, apart, 0.5, pen, p.wobble));
    drawn = hatchingLayer(drawn, dark, 4.0, hatchingStrokes(along, close, 0.5, pen, p.wobble));
    drawn = hatchingLayer(drawn, dark, 5.0, hatchingStrokes(across, close, 0.5, pen, p.wobble));
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
