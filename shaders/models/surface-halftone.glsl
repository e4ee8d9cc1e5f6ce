// SPDX-License-Identifier: MIT-0
#include "lib/drawn_place.glsl"

// A lattice across that axis which the surface faces most.
struct DotLattice {
    vec2 place;  // in cells
    float size;  // of a cell, in pixels, by its area on the picture
    float clear; // how far dots can be told apart
    float next;  // how far the next scale's dots have come in
};

DotLattice dotLattice(DrawnPlace at, float spacing) {
    vec3 a = vec3(abs(at.n.x), abs(at.n.y), abs(at.n.z));
    // Surfaces at 45 degrees, of which there are many, are all on one side.
    bool isX = a.x > a.y - 1e-4 && a.x > a.z - 1e-4;
    bool isY = !isX && a.y > a.z - 1e-4;
    vec3 across = isX ? vec3(1.0, 0.0, 0.0) : isY ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 right = isX ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 up = isY ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
    // At 45 degrees, as printers turn black.
    vec3 first = 0.70710678 * (right + up);
    vec3 second = 0.70710678 * (up - right);
    DotLattice lattice;
    // A square metre of the lattice is (n.v) / (n.across) of one on the picture.
    float seen = max(dot(at.n, at.v), 0.05) / max(abs(dot(at.n, across)), 0.3);
    float metre = sqrt(seen) / max(at.pixel, 1e-9);
    DrawnScale s = drawnScale(max(spacing, 2.0) / metre);
    lattice.place = vec2(dot(at.x, first) * s.cells, dot(at.x, second) * s.cells);
    lattice.size = metre / s.cells;
    lattice.next = s.next;
    lattice.clear = drawnClear(at, s);
    return lattice;
}

// How many pixels away the nearest dot of a lattice is that is shifted by a part of a cell.
float toNearestDot(DotLattice lattice, float shiftX, float shiftY) {
    float x = offWhole(lattice.place.x - shiftX);
    float y = offWhole(lattice.place.y - shiftY);
    return lattice.size * sqrt(x * x + y * y);
}

// The ink of a dot of a radius whose square is given. What the ramp of its edge adds to its area
// the strength takes away again, as halftone.glsl does, so that the ink of small dots grows as
// their area.
vec2 dotInk(float area, float away) {
    float radius = sqrt(area);
    float edge = radius + 0.5;
    float excess = radius > 0.5 ? 0.083333333 : edge * edge * edge / 3.0 - area;
    return faded(inked(radius - away), area / (area + excess), excess / (area + excess));
}

vec2 darker(vec2 a, vec2 b) {
    return a.x > b.x ? a : b;
}

// Dots that stay on the surface and keep their size on the picture: from one scale to the next
// three more grow in each cell, one after the other (after R. S. Johansen, Surface-Stable Fractal
// Dithering, 2025). Together they cover the share tone.x.
vec2 stableDots(DotLattice lattice, vec2 tone) {
    float number = exp2(2.0 * lattice.next);
    float second = clamp(number - 1.0, 0.0, 1.0);
    float third = clamp(number - 2.0, 0.0, 1.0);
    float fourth = clamp(number - 3.0, 0.0, 1.0);
    float together = 1.0 + second * second + third * third + fourth * fourth;
    // Dots overlap when they are large; at 0.75 of the distance they leave nothing bare.
    float reach = lattice.size * (0.56418958 + 0.19 * tone.x * tone.x);
    float area = reach * reach * tone.x / together;
    vec2 drawn = dotInk(area, toNearestDot(lattice, 0.0, 0.0));
    drawn = darker(drawn, dotInk(area * second * second, toNearestDot(lattice, 0.5, 0.5)));
    drawn = darker(drawn, dotInk(area * third * third, toNearestDot(lattice, 0.5, 0.0)));
    drawn = darker(drawn, dotInk(area * fourth * fourth, toNearestDot(lattice, 0.0, 0.5)));
    return clearMarks(drawn, lattice.clear, tone);
}

vec3 surfaceHalftone(Directions d, SurfaceHalftone p) {
    DrawnPlace at = drawnAt(p.place, p.placeNormal, p.placeView, p.placePixel);
    vec2 drawn = stableDots(dotLattice(at, p.cell), tones(d, p.toneDark, p.toneLight));
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
