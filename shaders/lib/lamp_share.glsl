// SPDX-License-Identifier: MIT-0
#include "lib/math.glsl"

// The share of a rectangular lamp that is seen in the direction d. The lamp stands one metre away
// along the unit vector c, upright, and measures 2 w by 2 h; its border fades over 2 `edge` > 0.
// d.c grows no smaller than a thousandth, so that nothing is divided by 0 beside or behind it.
float lampShare(vec3 d, vec3 c, float w, float h, float edge) {
    vec3 across = normalize(vec3(c.z, 0.0, -c.x));
    vec3 upward = cross(c, across);
    float facing = dot(d, c);
    float x = abs(dot(d, across)) / max(facing, 1e-3);
    float y = abs(dot(d, upward)) / max(facing, 1e-3);
    float inside = fallingStep(w - edge, w + edge, x) *
                   fallingStep(h - edge, h + edge, y);
    return facing > 0.0 ? inside : 0.0;
}
