// SPDX-License-Identifier: MIT-0
// Which texture coordinates a pixel has, rising along s.t and s.b, for models that lay a pattern on
// the surface.
#include "passes/texture.glsl"

in vec2 patternUv;

vec2 alongTangents(Surface s, vec2 uv) {
    return vec2(uv.x, imageFront(s) * surfaceSide * uv.y);
}

vec2 drawnCoordinates(Surface s) {
    return alongTangents(s, patternUv);
}

// How they change to the next pixel.
vec2 drawnCoordinatesRight(Surface s) {
    return alongTangents(s, dFdx(patternUv));
}

vec2 drawnCoordinatesUp(Surface s) {
    return alongTangents(s, dFdy(patternUv));
}
