// SPDX-License-Identifier: MIT-0
#include "lib/outlook.glsl"

// How much of a lamp's light the cloth in the direction d passes on, where the lamp shines on it
// from the direction c: 1 in the middle, falling off with the angle, the wider the less.
float tentPatch(vec3 d, vec3 c, float spread) {
    float away = max(1.0 - dot(d, c), 0.0);
    return exp(-away / (0.04 + 0.8 * spread));
}

// Cloth with three lit patches, the floor below, and the dark opening in front (+z).
vec3 lightTentEnvironment(Outlook o, LightTentEnvironment p) {
    float sides = tentPatch(o.d, vec3(-0.9806, 0.1961, 0.0), p.spread) +
                  tentPatch(o.d, vec3(0.9806, 0.1961, 0.0), p.spread);
    float top = tentPatch(o.d, vec3(0.0, 1.0, 0.0), p.spread);
    vec3 cloth = p.clothColor + vec3(p.sideIntensity * sides + p.topIntensity * top);
    float ground = fallingStep(-0.35, -0.05, o.d.y);
    vec3 light = lerp(cloth, p.floorColor, ground);

    float edge = 0.02 + 0.4 * p.softness;
    float across = abs(azimuthOf(o.d));
    float halfWidth = 0.5 * p.openingWidth;
    float open = fallingStep(halfWidth - edge, halfWidth + edge, across);
    float shut = smoothstep(0.0, edge, p.openingWidth); // an opening of no width lets none in
    open *= shut * fallingStep(0.75, 0.95, abs(o.d.y));
    return light * (1.0 - open) * p.tint * p.intensity;
}
