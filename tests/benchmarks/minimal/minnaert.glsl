// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 diffuseColor;
uniform float darkening;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    if (nl <= 0.0) {
        return vec3(0.0);
    }
    return DIFFUSE_COLOR * (nl * exp2((darkening - 1.0) * log2(nl * dot(n, v))));
}
