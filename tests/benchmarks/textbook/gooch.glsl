// SPDX-License-Identifier: GPL-3.0-or-later
vec3 gooch(Directions d, Gooch p) {
    vec3 warm = p.warmColor + p.warmMix * p.diffuseColor;
    vec3 cool = p.coolColor + p.coolMix * p.diffuseColor;
    return mix(cool, warm, 0.5 * (1.0 + dot(N, L))) + p.ambientAmount * p.ambientColor;
}
