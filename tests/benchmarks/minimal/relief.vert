// SPDX-License-Identifier: GPL-3.0-or-later
#version 410 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec2 uv;
layout(location = 4) in float side;

uniform mat4 objectToWorld;
uniform mat3 normalToWorld;
uniform mat4 worldToClip;
uniform vec3 eye;

out vec3 worldPosition;
out vec3 toEye;
centroid out vec3 worldNormal;
centroid out vec3 worldTangent;
centroid out vec2 surfaceUv;
out float surfaceSide;

void main() {
    worldPosition = (objectToWorld * vec4(position, 1.0)).xyz;
    toEye = eye - worldPosition;
    worldNormal = normalToWorld * normal;
    worldTangent = mat3(objectToWorld) * tangent;
    surfaceUv = uv;
    surfaceSide = side;
    gl_Position = worldToClip * vec4(worldPosition, 1.0);
}
