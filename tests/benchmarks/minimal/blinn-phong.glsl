// SPDX-License-Identifier: GPL-3.0-or-later
#include "lib/elementary.glsl"
uniform vec3 diffuseColor;
uniform vec3 specularColor;
uniform float shininess;
uniform float gloss;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    if (nl <= 0.0) {
        return vec3(0.0);
    }
    vec3 H = l + v;
    float nH = dot(n, H);
    vec3 P = H - nH * n;
    float lobe = powSC(dot(P, P), nH * nH, shininess);
    return DIFFUSE_COLOR * nl + specularColor * (gloss * lobe);
}
