// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 diffuseColor;
uniform vec3 warmColor;
uniform vec3 coolColor;
uniform float warmMix;
uniform float coolMix;
uniform float ambientAmount;
uniform vec3 ambientColor;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    vec3 warm = warmColor + warmMix * DIFFUSE_COLOR;
    vec3 cool = coolColor + coolMix * DIFFUSE_COLOR;
    return mix(cool, warm, 0.5 + 0.5 * dot(n, l)) + ambientAmount * ambientColor;
}
