// SPDX-License-Identifier: MIT-0
#include "lib/illumination.glsl"

// The direction to a light and its radiance, one pixel each.
vec4 numbersOf(Illumination i, int part) {
    return vec4(part == 0 ? i.l : i.radiance, 0.0);
}
