// SPDX-License-Identifier: GPL-3.0-or-later
vec3 toon(Directions d, Toon p) {
    float edge = 0.5 * p.softness;
    float nl = dot(N, L);
    vec3 tone = mix(p.shadowColor, p.diffuseColor,
        smoothstep(p.threshold - edge, p.threshold + edge, nl));
    if (p.tones == TOON_TONES_THREE) {
        tone = mix(tone, p.brightColor,
            smoothstep(p.brightThreshold - edge, p.brightThreshold + edge, nl));
    }
    float spot = acos(dot(reflect(-L, N), V));
    return tone + p.gloss * p.specularColor
        * (1.0 - smoothstep(p.spotSize - edge, p.spotSize + edge, spot));
}
