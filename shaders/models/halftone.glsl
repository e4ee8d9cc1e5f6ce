// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/marks.glsl"

// A dot in the middle of each cell, of the area that the coverage says, until dots touch; above
// that a gap of the rest's area at each corner. `cell` is the place in cells, `size` pixels wide.
// The ramp of an edge adds area to a small dot: pi (r^2 + 1/12), and pi (r + 1/2)^3 / 3 below
// r = 1/2, where it has no inside left; the factor takes it away again.
float halftoneDot(vec2 cell, float coverage, float size) {
    bool gaps = coverage > 0.25 * PI;
    float shift = gaps ? 0.5 : 0.0;
    vec2 middle = vec2(offWhole(cell.x + shift), offWhole(cell.y + shift));
    float radius = size * sqrt((gaps ? 1.0 - coverage : coverage) / PI);
    float edge = radius + 0.5;
    float drawn = radius > 0.5 ? radius * radius + 0.083333333 : edge * edge * edge / 3.0;
    float ink = radius * radius / drawn * inked(radius - size * length(middle));
    return gaps ? 1.0 - ink : ink;
}

// A line along each row of cells, `coverage` cells wide; above a half, a gap between lines. A ramp
// makes a line of w < 1 pixels ((w + 1) / 2)^2 wide, which the factor takes away again.
float halftoneLine(float row, float coverage, float size) {
    bool gaps = coverage > 0.5;
    float width = size * (gaps ? 1.0 - coverage : coverage);
    float strength = width < 1.0 ? width / sqr(0.5 * width + 0.5) : 1.0;
    float line = strength * inked(0.5 * width - size * offWhole(row + (gaps ? 0.5 : 0.0)));
    return gaps ? 1.0 - line : line;
}

// A screen of dots, lines or crossed lines whose coverage is 1 - n.l between two tones.
vec3 halftone(Directions d, Halftone p) {
    float coverage = darkness(d.nl, p.toneDark, p.toneLight);
    float size = max(p.cell, 1.0);
    vec2 cell = turnedPlace(d.pixel, p.angle) / size;
    float ink = 0.0;
    if (p.pattern == HALFTONE_PATTERN_DOTS) {
        ink = halftoneDot(cell, coverage, size);
    } else if (p.pattern == HALFTONE_PATTERN_LINES) {
        ink = halftoneLine(cell.y, coverage, size);
    } else {
        // Two sets of lines leave (1 - width)^2 of the paper.
        float each = 1.0 - safeSqrt(1.0 - coverage);
        float along = halftoneLine(cell.y, each, size);
        float across = halftoneLine(cell.x, each, size);
        ink = 1.0 - (1.0 - along) * (1.0 - across);
    }
    return (1.0 - ink) * p.diffuseColor + ink * p.inkColor;
}
