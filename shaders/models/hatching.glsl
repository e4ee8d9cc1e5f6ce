// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/marks.glsl"

// Strokes along x, `spacing` apart, the first one `shift` spacings from 0, of which each bends by
// up to `wobble` of a spacing in a rhythm of its own.
float hatchingStrokes(vec2 place, float spacing, float shift, float width, float wobble) {
    float rows = place.y / spacing - shift;
    float stroke = floor(rows + 0.5);
    float rhythm = place.x / (9.0 * spacing) + 0.381966 * stroke;
    float bend = wobble * 0.5 * sin(2.0 * PI * (rhythm - floor(rhythm)));
    float aside = abs(rows - stroke + bend) * spacing;
    // A pen does not fill the gap between its strokes.
    return inked(0.5 * min(width, 0.75 * spacing) - aside);
}

// What layer `layer` of strokes leaves of the paper: all its ink is there from tone
// (layer + 1) / 6 on.
float hatchingPaper(float tone, float layer, vec2 place, float spacing, float shift, Hatching p) {
    float share = clamp(6.0 * tone - layer, 0.0, 1.0);
    return 1.0 - share * hatchingStrokes(place, spacing, shift, p.penWidth, p.wobble);
}

// Six tones of strokes, each of which keeps the strokes of the lighter ones: wide apart, between
// them, then across, then both at half the spacing. E. Praun, H. Hoppe, M. Webb and A. Finkelstein,
// Real-Time Hatching, SIGGRAPH 2001, blend six tones of nested strokes in the same way.
vec3 hatching(Directions d, Hatching p) {
    float tone = darkness(d.nl, p.toneDark, p.toneLight);
    float spacing = max(p.spacing, 2.0);
    vec2 along = turnedPlace(d.pixel, p.angle);
    vec2 across = turnedPlace(d.pixel, p.angle + p.angleCross);
    float between = 0.5 * spacing;
    float paper = hatchingPaper(tone, 0.0, along, spacing, 0.0, p)
        * hatchingPaper(tone, 1.0, along, spacing, 0.5, p)
        * hatchingPaper(tone, 2.0, across, spacing, 0.0, p)
        * hatchingPaper(tone, 3.0, across, spacing, 0.5, p)
        * hatchingPaper(tone, 4.0, along, between, 0.5, p)
        * hatchingPaper(tone, 5.0, across, between, 0.5, p);
    return paper * p.diffuseColor + (1.0 - paper) * p.inkColor;
}
