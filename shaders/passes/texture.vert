// SPDX-License-Identifier: MIT-0
// Where images lie on the surface.

layout(location = 3) in vec2 uv;
layout(location = 4) in float side; // -1 where the mesh shows images mirrored

centroid out vec2 surfaceUv;
out float surfaceSide;

void placeImages() {
    surfaceUv = uv;
    surfaceSide = side;
}
