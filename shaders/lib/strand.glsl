// SPDX-License-Identifier: MIT-0

// A point of a strand of fur or grass that grows on a surface. A block of kind shells says where it
// is, how thick the strand is there, and what becomes of the light that falls on it.
struct Strand {
    float height; // 0 at the root, 1 at the tip of the longest strand around
    vec3 n;       // the surface's unit normal at the root, along the object's axes
    float nl;     // the cosine of the light's angle with the surface's normal, 0 .. 1
    float size;   // random numbers of the strand, 0 .. 1, the same all along it: for its length,
    float shade;  // its colour,
    float phase;  // and where it begins to curl
};
