// SPDX-License-Identifier: MIT-0
// The corners of the two faces of an edge, from object space to world space and to the screen.
#include "passes/blocks.glsl"

layout(location = 0) in vec3 position;

// Of each object, as in passes/surface.vert.
layout(location = 5) in mat3x4 objectToWorld;

out vec3 edgeCorner;

void placeCorner() {
    edgeCorner = vec4(position, 1.0) * objectToWorld;
    gl_Position = mat4(viewData[0], viewData[1], viewData[2], viewData[3]) * vec4(edgeCorner, 1.0);
}
