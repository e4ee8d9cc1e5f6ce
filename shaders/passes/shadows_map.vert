// SPDX-License-Identifier: MIT-0
// A depth map: from object space to the map of one light.

layout(location = 0) in vec3 position;

// Of each object, as in passes/surface.vert.
layout(location = 5) in mat3x4 objectToWorld;

uniform mat4 worldToMap;

void placeInMap() {
    gl_Position = worldToMap * vec4(vec4(position, 1.0) * objectToWorld, 1.0);
}
