// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 diffuseColor;
uniform vec3 specularColor;
uniform float shininess;
uniform float gloss;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    if (nl <= 0.0) {
        return vec3(0.0);
    }
    vec3 q = 2.0 * nl * n - l - v;
    float versine = 0.5 * dot(q, q);
    float t = max(1.0 - versine, 0.0);
    return DIFFUSE_COLOR * nl + specularColor * (gloss * t / (t + shininess * versine));
}
