// SPDX-License-Identifier: GPL-3.0-or-later
#include "lib/elementary.glsl"
uniform vec3 diffuseColor;
uniform vec3 specularColor;
uniform float width;
uniform float gloss;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    if (nl <= 0.0) {
        return vec3(0.0);
    }
    vec3 H = l + v;
    float HH = dot(H, H);
    float nH = dot(n, H);
    vec3 P = H - nH * n;
    float versine2 = 2.0 * dot(P, P) / (HH + nH * sqrt(HH));
    float w = max(width, 1e-6); // the slider goes down to 0
    float lobe = exp2(-1.4426950408889634 * acos2(min(versine2, 2.0)) / (w * w));
    return DIFFUSE_COLOR * nl + specularColor * (gloss * lobe);
}
