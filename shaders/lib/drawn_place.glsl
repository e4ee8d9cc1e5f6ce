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

// A scale of two: how much larger a lattice is, as a power of two, and how far it is on the way to
// the next finer one, 0 .. 1.
struct DrawnScale {
    float cells; // on a metre
    float next;
};

const float MAX_SCALE = 20.0;

// The lattice of which `apart` metres have one to two cells.
DrawnScale drawnScale(float apart) {
    float exact = clamp(-log2(max(apart, 1e-12)), -MAX_SCALE, MAX_SCALE);
    float whole = floor(exact);
    DrawnScale s;
    s.cells = exp2(whole);
    s.next = exact - whole;
    return s;
}

// How many metres along `way`, of length 1, a pixel passes at most, where the surface is seen at an
// angle. With g = way - (way.n) n it is |g - n (g.v) / (n.v)| of the pixel's width.
float passedByPixel(DrawnPlace at, vec3 way) {
    vec3 g = way - dot(way, at.n) * at.n;
    float slant = dot(g, at.v) / max(dot(at.n, at.v), 0.08);
    return at.pixel * sqrt(dot(g, g) + slant * slant);
}

// How steeply a surface runs through planes across `way`: 0 where it lies in one of them, and lines
// have no direction.
float steepnessAcross(DrawnPlace at, vec3 way) {
    float c = dot(way, at.n);
    return sqrt(max(1.0 - c * c, 0.0));
}

// A slow wave along lines, the same on all scales, in rows: from 1 to -1, half as much where the
// next finer scale is reached.
float drawnWave(float along, DrawnScale s) {
    float x = along * s.cells;
    float coarse = sin(2.0 * PI * (0.11 * x - floor(0.11 * x)));
    float fine = sin(2.0 * PI * (0.22 * x - floor(0.22 * x)));
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
