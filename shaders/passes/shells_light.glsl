// SPDX-License-Identifier: MIT-0

vec3 tintFor(float nl) {
    Strand lit = strand;
    lit.nl = clamp(nl, 0.0, 1.0);
    return max(shellsTint(lit, shells), vec3(0.0));
}

// What the model sends to the viewer from where the light meets the strand.
vec3 shellsModel(Directions d, Model p) {
    return tintFor(d.nl) * STRAND_MODEL(d, p);
}

// The factor of light from all around, whose mean cosine, weighted by itself, is 2/3.
vec3 shellsAround() {
    return tintFor(2.0 / 3.0);
}
