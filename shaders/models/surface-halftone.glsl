// SPDX-License-Identifier: MIT-0
#include "lib/drawn_curvature.glsl"

// How much more the surface faces one axis than the others, negative where it faces another more.
float facesMore(vec3 n, float number) {
    float x = abs(n.x);
    float y = abs(n.y);
    float z = abs(n.z);
    return number < 0.5 ? x - max(y, z) : (number < 1.5 ? y - max(z, x) : z - max(x, y));
}

// A lattice across one axis of the object.
struct DotLattice {
    float number; // of the axis
    vec3 axis;
    vec3 first;  // the directions of its rows
    vec3 second;
    vec2 place;  // in cells
    float cells; // on a metre
    float size;  // of a cell, in pixels, by its area on the picture
    float clear; // how far dots can be told apart
    float next;  // how far the next scale's dots have come in
};

DotLattice dotLattice(DrawnPlace at, float number, float spacing) {
    bool isX = number < 0.5;
    bool isY = !isX && number < 1.5;
    vec3 right = isX ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 up = isY ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
    DotLattice lattice;
    lattice.number = number;
    lattice.axis = isX ? vec3(1.0, 0.0, 0.0) : isY ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    // At 45 degrees, as printers turn black.
    lattice.first = 0.70710678 * (right + up);
    lattice.second = 0.70710678 * (up - right);
    // A square metre of the lattice is (n.v) / (n.axis) of one on the picture.
    float seen = max(dot(at.n, at.v), 0.05) / max(abs(dot(at.n, lattice.axis)), 0.3);
    float metre = sqrt(seen) / max(at.pixel, 1e-9);
    DrawnScale s = drawnScale(max(spacing, 2.0) / metre);
    lattice.place =
        vec2(dot(at.x, lattice.first) * s.cells, dot(at.x, lattice.second) * s.cells);
    lattice.cells = s.cells;
    lattice.size = metre / s.cells;
    lattice.next = s.next;
    lattice.clear = drawnClear(at, s);
    return lattice;
}

// Where the nearest dot of a lattice is that is shifted by a part of a cell: in cells, from there to
// here.
vec2 fromNearestDot(DotLattice lattice, float shiftX, float shiftY) {
    float x = lattice.place.x - shiftX;
    float y = lattice.place.y - shiftY;
    return vec2(x - floor(x + 0.5), y - floor(y + 0.5));
}

// How much more the surface faces the lattice's axis than the others in the middle of a dot, by how
// it bends from here to there.
float facesThere(DotLattice lattice, DrawnPlace at, DrawnBend bend, vec2 off) {
    vec3 across = (off.x * lattice.first + off.y * lattice.second) * (-1.0 / lattice.cells);
    float facing = dot(at.n, lattice.axis);
    float divisor = facing < 0.0 ? min(facing, -0.3) : max(facing, 0.3);
    vec3 way = across - lattice.axis * (dot(across, at.n) / divisor);
    // Where the surface bends much within a cell, that says nothing about the dot's middle.
    float bent = (dot(bend.diagonal, bend.diagonal) + 2.0 * dot(bend.mixed, bend.mixed)) /
        (lattice.cells * lattice.cells);
    vec3 n = at.n + bentAlong(bend, way) * (1.0 / (1.0 + 4.0 * bent));
    return facesMore(n, lattice.number);
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

// One dot, which is there where the surface faces the lattice's axis in its middle. Within a degree
// of where another axis takes over dots of both are smaller. Where it is dark dots are so large that
// they reach beyond their cells: there a dot also counts where the axis is faced here, so that
// nothing stays bare between two lattices.
vec2 stableDot(DotLattice lattice, DrawnPlace at, DrawnBend bend, vec2 shift, float area,
    float dark) {
    vec2 off = fromNearestDot(lattice, shift.x, shift.y);
    float there = facesThere(lattice, at, bend, off);
    float stands = clamp(0.5 + 30.0 * there, 0.0, 1.0);
    float fills = clamp(1.0 + 30.0 * max(there, facesMore(at.n, lattice.number)), 0.0, 1.0);
    float large = smoothstep(0.5, 0.75, dark);
    float share = max((1.0 - large) * stands, large * fills);
    return dotInk(area * share, lattice.size * sqrt(off.x * off.x + off.y * off.y));
}

// Dots that stay on the surface and keep their size on the picture: from one scale to the next
// three more grow in each cell, one after the other (after R. S. Johansen, Surface-Stable Fractal
// Dithering, 2025). Together they cover the share tone.x.
vec2 stableDots(DotLattice lattice, DrawnPlace at, DrawnBend bend, vec2 tone) {
    float number = exp2(2.0 * lattice.next);
    float second = clamp(number - 1.0, 0.0, 1.0);
    float third = clamp(number - 2.0, 0.0, 1.0);
    float fourth = clamp(number - 3.0, 0.0, 1.0);
    float together = 1.0 + second * second + third * third + fourth * fourth;
    // Dots overlap when they are large; at 0.75 of the distance they leave nothing bare.
    float reach = lattice.size * (0.56418958 + 0.19 * tone.x * tone.x);
    float area = reach * reach * tone.x / together;
    vec2 drawn = stableDot(lattice, at, bend, vec2(0.0), area, tone.x);
    drawn = darker(drawn,
        stableDot(lattice, at, bend, vec2(0.5, 0.5), area * second * second, tone.x));
    drawn = darker(drawn,
        stableDot(lattice, at, bend, vec2(0.5, 0.0), area * third * third, tone.x));
    drawn = darker(drawn,
        stableDot(lattice, at, bend, vec2(0.0, 0.5), area * fourth * fourth, tone.x));
    return drawn;
}

vec3 surfaceHalftone(Directions d, SurfaceHalftone p) {
    DrawnPlace at = drawnAt(p.place, p.placeNormal, p.placeView, p.placePixel);
    DrawnBend bend = drawnBend(p.placeCurvature, p.placeCurvatureMixed);
    vec2 tone = tones(d, p.toneDark, p.toneLight);
    vec2 drawn = vec2(0.0, 1.0);
    float clear = 1.0;
    for (int i = 0; i < 3; ++i) {
        DotLattice lattice = dotLattice(at, float(i), p.cell);
        clear = min(clear, lattice.clear);
        if (abs(dot(at.n, lattice.axis)) > 0.3) {
            drawn = overInk(drawn, stableDots(lattice, at, bend, tone));
        }
    }
    drawn = clearMarks(drawn, clear, tone);
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
