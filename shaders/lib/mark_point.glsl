// SPDX-License-Identifier: MIT-0

// A place on a mark that is set on a surface. A block of kind strokes says how large the mark is,
// which way it points, where in its rectangle ink is, and which.
struct MarkPoint {
    float along;  // 0 where the mark begins, 1 where it ends
    float across; // 0 on its left side, 1 on its right one
    float pixel;  // how wide a pixel is, in widths of the mark
    float aspect; // the mark's length over its width
    vec3 n;       // unit, in world space: the surface's normal where the mark is set,
    vec3 t;       // its tangent,
    vec3 v;       // and the way to the viewer
    vec3 radiance; // what the surface sends to the viewer from there
    float order;  // the share of the marks around that are set before it, 0 .. 1
    float size;   // random numbers of the mark, 0 .. 1
    float shade;
    float phase;
};
