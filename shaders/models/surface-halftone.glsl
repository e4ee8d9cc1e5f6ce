// SPDX-License-Identifier: MIT-0
#include "lib/drawn_place.glsl"

// A lattice across that axis which the surface faces most.
struct DotLattice {
    vec2 place; // in cells
    float size; // of a cell, in pixels, by its area on the picture
    float next; // how far the next scale's dots have come in
};

// What is seen of a way along one of the lattice's axes, which rises with the surface.
vec3 seenOnSurface(vec3 way, vec3 across, DrawnPlace at) {
    float c = dot(across, at.n);
    float rise = -dot(way, at.n) / (c < 0.0 ? min(c, -0.3) : max(c, 0.3));
    vec3 lifted = way + rise * across;
    return lifted - dot(lifted, at.v) * at.v;
}

DotLattice dotLattice(DrawnPlace at, float spacing) {
    vec3 a = vec3(abs(at.n.x), abs(at.n.y), abs(at.n.z));
    bool isX = a.x >= a.y && a.x >= a.z;
    bool isY = !isX && a.y >= a.z;
    vec3 across = isX ? vec3(1.0, 0.0, 0.0) : isY ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 right = isX ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 up = isY ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
    // At 45 degrees, as printers turn black.
    vec3 first = 0.70710678 * (right + up);
    vec3 second = 0.70710678 * (up - right);
    DotLattice lattice;
    vec3 area = cross(seenOnSurface(first, across, at), seenOnSurface(second, across, at));
    float metre = sqrt(max(sqrt(dot(area, area)), 1e-4)) / max(at.pixel, 1e-9);
    DrawnScale s = drawnScale(max(spacing, 2.0) / metre);
    lattice.place = vec2(dot(at.x, first) * s.cells, dot(at.x, second) * s.cells);
    lattice.size = metre / s.cells;
    lattice.next = s.next;
    return lattice;
}

// How many pixels away the nearest dot of a lattice is that is shifted by a part of a cell.
float toNearestDot(DotLattice lattice, float shiftX, float shiftY) {
    float x = offWhole(lattice.place.x - shiftX);
    float y = offWhole(lattice.place.y - shiftY);
    return lattice.size * sqrt(x * x + y * y);
}

// The ink of a dot; one that is smaller than a pixel is pale.
float dotInk(float radius, float away) {
    return clamp(0.5 + radius - away, 0.0, 1.0) * clamp(2.0 * radius, 0.0, 1.0);
}

// Dots that stay on the surface and keep their size on the picture: from one scale to the next
// three more grow in each cell, one after the other (after R. S. Johansen, Surface-Stable Fractal
// Dithering, 2025). Together they cover the share `dark`.
vec2 stableDots(DotLattice lattice, float dark) {
    float number = exp2(2.0 * lattice.next);
    float second = clamp(number - 1.0, 0.0, 1.0);
    float third = clamp(number - 2.0, 0.0, 1.0);
    float fourth = clamp(number - 3.0, 0.0, 1.0);
    float together = 1.0 + second * second + third * third + fourth * fourth;
    // Dots overlap when they are large; at 0.75 of the distance they leave nothing bare.
    float radius = lattice.size * sqrt(dark / together) * (0.56418958 + 0.19 * dark * dark);
    float ink = dotInk(radius, toNearestDot(lattice, 0.0, 0.0));
    ink = max(ink, dotInk(radius * second, toNearestDot(lattice, 0.5, 0.5)));
    ink = max(ink, dotInk(radius * third, toNearestDot(lattice, 0.5, 0.0)));
    ink = max(ink, dotInk(radius * fourth, toNearestDot(lattice, 0.0, 0.5)));
    return vec2(ink, 1.0 - ink);
}

vec3 surfaceHalftone(Directions d, SurfaceHalftone p) {
    DrawnPlace at;
    at.x = p.place;
    at.n = unitVector(p.placeNormal, vec3(0.0, 0.0, 1.0));
    at.v = unitVector(p.placeView, at.n);
    at.pixel = p.placePixel;
    vec2 drawn = stableDots(dotLattice(at, p.cell), tones(d, p.toneDark, p.toneLight).x);
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
