// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/marks.glsl"

// A dot in the middle of each cell, of the area that the tone says, until dots touch; above that a
// gap of the rest's area at each corner. `cell` is the place in cells, `size` pixels wide.
// The ramp of an edge adds area to a small dot: pi (r^2 + 1/12), and pi (r + 1/2)^3 / 3 below
// r = 1/2, where it has no inside left; the strength takes it away again.
vec2 halftoneDot(vec2 cell, vec2 tone, float size) {
    bool gaps = tone.x > 0.25 * PI;
    float shift = gaps ? 0.5 : 0.0;
    vec2 middle = vec2(offWhole(cell.x + shift), offWhole(cell.y + shift));
    float radius = size * sqrt((gaps ? tone.y : tone.x) / PI);
    float area = radius * radius;
    float edge = radius + 0.5;
    float excess = radius > 0.5 ? 0.083333333 : edge * edge * edge / 3.0 - area;
    vec2 mark = inked(radius - size * length(middle));
    vec2 spot = faded(mark, area / (area + excess), excess / (area + excess));
    return gaps ? vec2(spot.y, spot.x) : spot;
}

// A line along each row of cells, as wide as the tone; above a half, a gap between lines.
vec2 halftoneLine(float row, vec2 tone, float size) {
    bool gaps = tone.x > 0.5;
    float width = size * (gaps ? tone.y : tone.x);
    vec2 line = lineMark(width, size * offWhole(row + (gaps ? 0.5 : 0.0)));
    return gaps ? vec2(line.y, line.x) : line;
}

// A screen of dots, lines or crossed lines that cover 1 - n.l, between two tones.
vec3 halftone(Directions d, Halftone p) {
    vec2 tone = tones(d, p.toneDark, p.toneLight);
    float size = max(p.cell, 1.0);
    vec2 cell = turnedPlace(d.pixel, p.angle) / size;
    vec2 drawn = vec2(0.0);
    if (p.pattern == HALFTONE_PATTERN_DOTS) {
        drawn = halftoneDot(cell, tone, size);
    } else if (p.pattern == HALFTONE_PATTERN_LINES) {
        drawn = halftoneLine(cell.y, tone, size);
    } else {
        // Two sets of lines leave the square of what one leaves.
        float bare = sqrt(tone.y);
        vec2 each = vec2(tone.x / (1.0 + bare), bare);
        vec2 along = halftoneLine(cell.y, each, size);
        vec2 across = halftoneLine(cell.x, each, size);
        drawn = vec2(along.x + along.y * across.x, along.y * across.y);
    }
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
