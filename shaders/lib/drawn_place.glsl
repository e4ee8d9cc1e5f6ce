// SPDX-License-Identifier: MIT-0
// For models that draw marks on the surface itself, whose size on the picture stays: marks are
// nested over scales, so that nearer more of them come between those that are there.
#include "lib/directions.glsl"
#include "lib/marks.glsl"

// Where a drawing is on a surface. Lengths are metres along the object's axes.
struct DrawnPlace {
    vec3 x;
    vec3 n;      // unit, on the viewer's side
    vec3 v;      // unit, to the viewer
    float pixel; // how wide a pixel of the picture is there
};

// From what the engine gives a model of it; vectors may have any length.
DrawnPlace drawnAt(vec3 x, vec3 n, vec3 v, float pixel) {
    DrawnPlace at;
    at.x = x;
    at.n = unitVector(n, vec3(0.0, 0.0, 1.0));
    at.v = unitVector(v, at.n);
    at.pixel = pixel;
    return at;
}

// A scale of two: how much larger a lattice is, as a power of two, and how far it is on the way to
// the next finer one, 0 .. 1.
struct DrawnScale {
    float cells; // on a metre
    float next;
};

const float MAX_SCALE = 40.0;

// The lattice of which `apart` metres have one to two cells.
DrawnScale drawnScale(float apart) {
    float cell = clamp(apart, exp2(-MAX_SCALE), exp2(MAX_SCALE));
    DrawnScale s;
    s.cells = exp2(floor(-log2(cell)));
    // Of the ratio, since the logarithm of a large number has fewer digits behind its point.
    s.next = clamp(-log2(cell * s.cells), 0.0, 1.0);
    return s;
}

// How far rows can be told from each other: so far from the object's middle, in cells, that a float
// has few digits left for a part of one, marks go over into an even tone.
float drawnClear(DrawnPlace at, DrawnScale s) {
    float cells = (abs(at.x.x) + abs(at.x.y) + abs(at.x.z)) * s.cells;
    return clamp(2.0 - cells / 131072.0, 0.0, 1.0);
}

// Marks, and where they cannot be told apart the even tone that they have.
vec2 clearMarks(vec2 drawn, float clear, vec2 even) {
    return clear * drawn + (1.0 - clear) * even;
}

// How many metres along `way`, of length 1, a pixel passes at most, where the surface is seen at an
// angle. With g = way - (way.n) n it is |g - n (g.v) / (n.v)| of the pixel's width. Below a tenth
// of that no line is drawn (clearOfPlanes).
float passedByPixel(DrawnPlace at, vec3 way) {
    vec3 g = way - dot(way, at.n) * at.n;
    float slant = dot(g, at.v) / max(dot(at.n, at.v), 0.15);
    return max(at.pixel, 1e-9) * max(sqrt(dot(g, g) + slant * slant), 0.1);
}

// How clear lines are where planes across `way` cut the surface: where that lies in one of them
// they have no direction, and none is drawn.
float clearOfPlanes(DrawnPlace at, vec3 way) {
    vec3 g = way - dot(way, at.n) * at.n;
    return clamp(6.0 * sqrt(dot(g, g)) - 0.6, 0.0, 1.0);
}

// A slow wave along lines, the same on all scales, in rows: from 1 to -1, half as much where the
// next finer scale is reached.
float drawnWave(float along, DrawnScale s) {
    float x = along * s.cells;
    // To the nearest whole number: a phase just below one keeps its digits.
    float coarse = sin(2.0 * PI * (0.11 * x - floor(0.11 * x + 0.5)));
    float fine = sin(2.0 * PI * (0.22 * x - floor(0.22 * x + 0.5)));
    return exp2(-s.next) * (coarse + s.next * (fine - coarse));
}

// How far a row is from the nearest of a class, in rows: class 0 are whole numbers, 1 halves
// between these, 2 and 3 the quarters and eighths between those.
float offClass(float row, float number) {
    float finer = exp2(max(number - 1.0, 0.0));
    float shift = number < 0.5 ? 0.0 : 0.5;
    return offWhole(row * finer - shift) / finer;
}

// How many halvings a class lies behind the rows of the coarsest scale that is drawn: it moves to 0
// as the surface comes nearer, where it is class 0 of the next scale.
float classDepth(float number, float next) {
    return max(number - next, 0.0);
}

vec2 overInk(vec2 drawn, vec2 added) {
    return vec2(drawn.x + drawn.y * added.x, drawn.y * added.y);
}
