// SPDX-License-Identifier: MIT-0
#include "lib/lamp_share.glsl"
#include "lib/sky_ray.glsl"

// Walls that grow darker downwards from the ceiling to the floor, with the step at the horizon
// softened, and five lamps: a large key in front on the right, a wide dim fill on the left, two
// upright strips behind that draw the edges of things, and a panel under the ceiling.
vec3 studioEnvironment(SkyRay o, StudioEnvironment p) {
    float edge = 0.01 + 0.2 * p.softness;
    float horizon = 0.02 + 0.3 * p.horizon;
    float height = max(o.d.y, 0.0);
    vec3 wall = lerp(p.wallColor, p.ceilingColor, height);
    vec3 light = smoothLerp(p.floorColor, wall, -horizon, horizon, o.d.y);

    vec3 keyLamp = vec3(0.5774, 0.5774, 0.5774);
    vec3 fillLamp = vec3(-0.8616, 0.2872, 0.4185);
    vec3 leftStrip = vec3(-0.6882, 0.2294, -0.6882);
    vec3 rightStrip = vec3(0.7717, 0.1929, -0.6060);
    vec3 panel = vec3(0.0, 0.9950, 0.0995);
    light += vec3(p.keyIntensity * lampShare(o.d, keyLamp, 0.5, 0.5, edge));
    light += vec3(p.fillIntensity * lampShare(o.d, fillLamp, 0.7, 0.9, edge));
    light += vec3(p.rimIntensity * lampShare(o.d, leftStrip, 0.16, 0.8, min(edge, 0.16)));
    light += vec3(p.rimIntensity * lampShare(o.d, rightStrip, 0.16, 0.8, min(edge, 0.16)));
    light += vec3(p.topIntensity * lampShare(o.d, panel, 0.8, 0.35, edge));
    return light * p.tint * p.intensity;
}
