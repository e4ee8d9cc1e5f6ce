// SPDX-License-Identifier: MIT-0
// Directions on surfaces that have a grain.
#include "lib/directions.glsl"

// The same directions with the tangents turned by `angle` (radians) about n, t towards b: the grain
// goes with the surface, never with the camera.
Directions alongGrain(Directions d, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    Directions g = d;
    g.lt = c * d.lt + s * d.lb;
    g.lb = c * d.lb - s * d.lt;
    g.vt = c * d.vt + s * d.vb;
    g.vb = c * d.vb - s * d.vt;
    g.tH = c * d.tH + s * d.bH;
    g.bH = c * d.bH - s * d.tH;
    g.ht = c * d.ht + s * d.hb;
    g.hb = c * d.hb - s * d.ht;
    return g;
}
