// SPDX-License-Identifier: MIT-0
// The colour of a vertex.

// What is missing from white, and the alpha. A mesh without it has (0, 0, 0, 1), as OpenGL gives
// it: white.
layout(location = 14) in vec4 missingColor;

centroid out vec4 vertexColor; // beyond an edge it would leave its range

void placeVertexColor() {
    vertexColor = vec4(1.0 - missingColor.rgb, missingColor.a);
}
