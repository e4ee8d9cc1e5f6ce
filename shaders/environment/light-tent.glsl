// SPDX-License-Identifier: MIT-0
#include "lib/sky_ray.glsl"

// How much of a lamp's light the cloth in the direction d passes on, where the lamp shines on it
// from the direction c: 1 in the middle, falling off with the angle, the wider the less.
float tentPatch(vec3 d, vec3 c, float spread) {
    float away = max(1.0 - dot(d, c), 0.0);
    return exp(-away / (0.04 + 0.8 * spread));
}

// Cloth with three lit patches, the floor below, and the dark opening in front (+z).
vec3 lightTentEnvironment(SkyRay o, LightTentEnvironment p) {
    float sides = tentPatch(o.d, vec3(-0.9806, 0.1961, 0.0), p.spread) +
                  tentPatch(o.d, vec3(0.9806, 0.1961, 0.0), p.spread);
    float top = tentPatch(o.d, vec3(0.0, 1.0, 0.0), p.spread);
    vec3 cloth = p.clothColor + vec3(p.sideIntensity * sides + p.topIntensity * top);
    vec3 light = smoothLerp(p.floorColor, cloth, -0.35, -0.05, o.d.y);

    float edge = 0.02 + 0.4 * p.softness;
    float across = abs(azimuthOf(o.d));
    float halfWidth = 0.5 * p.openingWidth;
    // The share of cloth: beside the opening, where that is of no width, and above and below it.
    float closed = smoothstep(0.75, 0.95, abs(o.d.y));
    closed += (1.0 - closed) * fallingStep(0.0, edge, p.openingWidth);
    closed += (1.0 - closed) * smoothstep(halfWidth - edge, halfWidth + edge, across);
    return light * closed * p.tint * p.intensity;
}
