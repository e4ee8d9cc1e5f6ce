// SPDX-License-Identifier: MIT-0
// From object space to world space and to the screen.
#include "passes/blocks.glsl"
#include "lib/math.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;

// Of each object. The columns are rows of the matrix to world space, and of its inverse transpose,
// which keeps normals perpendicular under any scale.
layout(location = 5) in mat3x4 objectToWorld;
layout(location = 8) in mat3 normalToWorld;

out vec3 worldPosition;
out vec3 toEye; // few fragments need to know where the eye itself is
centroid out vec3 worldNormal; // beyond an edge it would turn away
centroid out vec3 worldTangent;

// Normal and tangent are unit, or zero where the vertex has none.
void placeSurface() {
    worldPosition = vec4(position, 1.0) * objectToWorld;
    toEye = viewData[4].xyz - worldPosition;
    vec3 across = normal * normalToWorld;
    worldNormal = across * inversesqrt(max(dot(across, across), 1e-30));
    worldTangent = safeNormalize(vec4(tangent, 0.0) * objectToWorld, vec3(0.0));
    mat4 worldToClip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]);
    gl_Position = worldToClip * vec4(worldPosition, 1.0);
    // Where the far side of a shape meets the near one, along its outline, their depths differ by
    // less than they are rounded: without this, pixels of it show.
    gl_Position.z += dot(worldNormal, toEye) < 0.0 ? viewData[5].x : 0.0;
}
