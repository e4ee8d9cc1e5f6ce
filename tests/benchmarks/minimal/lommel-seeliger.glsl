// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 diffuseColor;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = max(dot(n, l), 0.0);
    return DIFFUSE_COLOR * (nl / (nl + dot(n, v)));
}
