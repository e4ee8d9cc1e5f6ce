// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that is seen from either side, whatever the winding of its triangles; near the outline
// its normal is turned as everywhere.
#include "lib/math.glsl"

in vec3 worldPosition;
in vec3 toEye;
centroid in vec3 worldNormal;
layout(location = 0) out vec4 color;

vec3 towardsViewer(vec3 n, vec3 v) {
    float missing = 0.01 - dot(n, v);
    return missing > 0.0 ? normalize(n + missing * v) : n;
}

// Between normals that oppose there is none.
vec3 seenNormal(vec3 v) {
    vec3 face = cross(dFdx(toEye), dFdy(toEye));
    vec3 n = worldNormal * inversesqrt(max(dot(worldNormal, worldNormal), 1e-30));
    return towardsViewer((dot(n, face) < 0.0) != (dot(face, v) < 0.0) ? -n : n, v);
}

// A half float ends there.
vec4 stored(vec3 light) {
    return vec4(min(light, vec3(65504.0)), 1.0);
}
