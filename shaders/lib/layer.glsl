// SPDX-License-Identifier: MIT-0
// A surface among those that shine through each other.
#include "lib/math.glsl"

struct Layer {
    float depth;   // 0: the nearest place in the picture that lets something through, 1: the farthest
    float opacity; // 0 .. 1
};
