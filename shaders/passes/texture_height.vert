// SPDX-License-Identifier: MIT-0
// Where images lie at a pixel's middle, beyond a triangle's edge too: from pixel to pixel it goes
// on as evenly as worldPosition.
#include "passes/texture.vert"

out vec2 evenUv;

void placeHeights() {
    evenUv = uv;
}
