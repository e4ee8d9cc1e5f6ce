// SPDX-License-Identifier: MIT-0
#include "lib/elementary.glsl"
#include "lib/illumination.glsl"
#include "lib/math.glsl"

// The versine of the narrowest outer cone, 4.5e-7 rad: below that the rounding of a unit vector
// decides what is inside.
const float MIN_CONE = 1e-13;

// The share of a spot light that leaves it towards -l.
// With u = 1 - cos of the angle to the axis and ui, uo those of the inner and outer angle:
// ((uo - u) / (uo - ui))^exponent between them. Versines, because a cone of 0.1 degrees spans only
// 26 float steps of the cosine; behind the light uo - u comes from the versines of the angles that
// are left to 180 degrees. Equal angles: a step; an inner cone of 180 degrees is everywhere.
float spotCone(vec3 l, SpotLight p) {
    vec3 forward = l + p.direction;
    vec3 behind = l - p.direction;
    float u = 0.5 * dot(forward, forward);
    float uo = max(versineOf(p.angleOuter), MIN_CONE);
    float ui = p.angleInner < p.angleOuter ? min(versineOf(p.angleInner), uo) : uo;
    float inside = uo - u;
    if (u > 1.0) {
        inside = 0.5 * dot(behind, behind) - versineOf(max(PI - p.angleOuter, 0.0));
    }
    if (u <= ui || p.angleInner >= PI) {
        return 1.0;
    }
    float band = uo - ui;
    if (inside <= 0.0 || band <= 0.0) {
        return 0.0;
    }
    return pow1m((u - ui) / band, min(inside / band, 1.0), p.falloffExponent);
}

// At the light itself, where no direction leads to it, the point counts as straight in its beam.
Illumination spotLight(vec3 x, SpotLight p) {
    vec3 toLight = p.position - x;
    float range = metresTo(toLight);
    float attenuation = distanceAttenuation(range, p.falloff == SPOT_LIGHT_FALLOFF_INVERSE_SQUARE,
        p.distanceMinimum, p.attenuationConstant, p.attenuationLinear, p.attenuationQuadratic,
        p.range);
    Illumination i;
    i.l = range > 0.0 ? toLight / range : -p.direction;
    i.radiance = p.color * (p.intensity * attenuation * spotCone(i.l, p));
    return i;
}
