// SPDX-License-Identifier: MIT-0
// The normal, depth and number of what is drawn, for passes over the picture.

uniform mat3 worldToCamera;
uniform float objectNumber; // from 1 on

in vec3 toEye;
centroid in vec3 worldNormal;

layout(location = 0) out vec4 storedNormal;
layout(location = 1) out vec4 storedDepth;

void main() {
    vec3 seen = dot(worldNormal, toEye) < 0.0 ? -worldNormal : worldNormal;
    vec3 n = worldToCamera * seen;
    storedNormal = vec4(n * inversesqrt(max(dot(n, n), 1e-30)), 0.0);
    storedDepth = vec4((worldToCamera * toEye).z, objectNumber, 0.0, 0.0);
}
