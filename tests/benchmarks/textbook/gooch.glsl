// SPDX-License-Identifier: GPL-3.0-or-later
vec3 gooch(Directions d, Gooch p) {
    float nl = dot(N, L);
    vec3 warm = p.warmColor + p.warmMix * p.diffuseColor;
    vec3 cool = p.coolColor + p.coolMix * p.diffuseColor;
    vec3 ambient = p.ambientColor;
    if (p.ambientRule == GOOCH_AMBIENT_RULE_RAW) {
        ambient = 0.5 * (p.warmColor + p.coolColor);
    }
    if (p.ambientRule == GOOCH_AMBIENT_RULE_MIXED) {
        ambient = 0.5 * (warm + cool);
    }
    vec3 tone = mix(cool, warm, 0.5 * (1.0 + nl));
    if (p.blending == GOOCH_BLENDING_PRINTED) {
        tone = mix(warm, cool, 0.5 * (1.0 + nl));
    } else if (p.lights == GOOCH_LIGHTS_TWO) {
        tone = 0.5 * (warm + cool) + max(0.5 * (warm - cool), vec3(0.0)) * max(nl, 0.0)
            + max(0.5 * (cool - warm), vec3(0.0)) * max(-nl, 0.0);
    }
    return tone + p.ambientAmount * ambient;
}
