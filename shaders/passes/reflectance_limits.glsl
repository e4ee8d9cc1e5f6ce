// SPDX-License-Identifier: MIT-0
// What a model reflects, before moments are taken of it: what is not a number says nothing, and sums
// of what is left, and their squares, stay numbers.
vec3 reflectanceLimited(vec3 x) {
    return vec3(x.r > 0.0 ? min(x.r, 1e15) : 0.0, x.g > 0.0 ? min(x.g, 1e15) : 0.0,
        x.b > 0.0 ? min(x.b, 1e15) : 0.0);
}
