// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that is seen from either side; near the outline its normal is bent as everywhere.
#include "lib/math.glsl"

in vec3 worldPosition;
in vec3 worldNormal;
layout(location = 0) out vec4 color;
uniform vec3 eye;

vec3 seenNormal(vec3 v) {
    vec3 n = normalize(gl_FrontFacing ? worldNormal : -worldNormal);
    float lack = 0.01 - dot(n, v);
    return lack > 0.0 ? normalize(n + lack * v) : n;
}
