// SPDX-License-Identifier: MIT-0
// Texture coordinates of patterns: in the middle of each pixel, also of one that the triangle does not
// cover there, so that they change evenly from pixel to pixel and neighbouring triangles agree. Those
// of passes/texture.vert lie within the triangle, unevenly along its edges.

out vec2 patternUv;

void placePattern() {
    patternUv = uv;
}
