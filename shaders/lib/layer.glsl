// SPDX-License-Identifier: MIT-0
// A surface among others that are transparent.
#include "lib/math.glsl"

struct Layer {
    float depth;   // 0: the nearest transparent place in the picture, 1: the farthest
    float opacity; // 0 .. 1
};
