// SPDX-License-Identifier: GPL-3.0-or-later
#include "lib/elementary.glsl"
uniform vec3 diffuseColor;
uniform vec3 shadowColor;
uniform vec3 specularColor;
uniform float threshold;
uniform float softness;
uniform float spotSize;
uniform float gloss;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    float edge = max(softness, 1e-3);
    vec3 tone = mix(shadowColor, DIFFUSE_COLOR, smoothstep(-0.5, 0.5, (nl - threshold) / edge));
    if (nl <= 0.0 || spotSize <= 0.0) {
        return tone;
    }
    vec3 q = 2.0 * nl * n - l - v;
    float inside = 1.0 - 0.5 * dot(q, q) / versineOf(spotSize);
    return tone + specularColor * (gloss * smoothstep(-0.5, 0.5, inside / edge));
}
