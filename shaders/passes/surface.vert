// SPDX-License-Identifier: MIT-0
// From object space to world space and to the screen.
#include "passes/blocks.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;

// Of each object. The columns are rows of the matrix to world space, and of its inverse transpose,
// which keeps normals perpendicular under any scale.
layout(location = 5) in mat3x4 objectToWorld;
layout(location = 8) in mat3 normalToWorld;

out vec3 worldPosition;
centroid out vec3 worldNormal; // beyond an edge it would turn away
centroid out vec3 worldTangent;

// Where the far side of a shape meets the near one, along its outline, their depths differ by less
// than they are rounded: the far side lies back by this share of its distance, or pixels of it show.
const float FAR_SIDE = 1e-4;

// How far that is in depths, which is the same at every distance: the eye's own depth.
float farSide(vec3 x, vec3 n, mat4 worldToClip) {
    vec3 toEye = viewData[4].xyz - x;
    return dot(n, toEye) < 0.0 ? -FAR_SIDE * (worldToClip * vec4(viewData[4].xyz, 1.0)).z : 0.0;
}

// The normal is unit, or zero where the vertex has none; the tangent's length is restored per
// fragment.
void placeSurface() {
    worldPosition = vec4(position, 1.0) * objectToWorld;
    vec3 across = normal * normalToWorld;
    worldNormal = across * inversesqrt(max(dot(across, across), 1e-30));
    worldTangent = vec4(tangent, 0.0) * objectToWorld;
    mat4 worldToClip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]);
    gl_Position = worldToClip * vec4(worldPosition, 1.0);
    gl_Position.z += farSide(worldPosition, worldNormal, worldToClip);
}
