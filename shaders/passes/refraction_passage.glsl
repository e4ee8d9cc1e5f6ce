// SPDX-License-Identifier: MIT-0
// The way of a ray through a transparent body.
#include "lib/interface.glsl"

struct Passage {
    vec3 x;       // where it leaves
    vec3 leaving; // unit, the way it goes on from there
    vec3 inner;   // unit, the way of what is mirrored there
    float kept;   // the share of that
    float way;    // metres inside
};

// The ray from the eye, where it meets the surface.
Interface entering(Surface s, int channel) {
    Interface c;
    c.l = s.v;
    c.n = s.n;
    c.channel = channel;
    c.leaves = false;
    return c;
}
