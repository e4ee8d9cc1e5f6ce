// SPDX-License-Identifier: MIT-0
// From object space to world space and to the screen.
#include "passes/blocks.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 worldTangent;

// Rows 0 to 2 of objectData hold the matrix to world space, rows 3 to 5 its inverse transpose,
// which keeps normals perpendicular under any scale. Lengths are restored per fragment.
void placeSurface() {
    vec4 x = vec4(position, 1.0);
    vec4 t = vec4(tangent, 0.0);
    worldPosition = vec3(dot(objectData[0], x), dot(objectData[1], x), dot(objectData[2], x));
    worldNormal = vec3(dot(objectData[3].xyz, normal), dot(objectData[4].xyz, normal),
        dot(objectData[5].xyz, normal));
    worldTangent = vec3(dot(objectData[0], t), dot(objectData[1], t), dot(objectData[2], t));
    gl_Position = mat4(viewData[0], viewData[1], viewData[2], viewData[3]) * vec4(worldPosition, 1.0);
}
