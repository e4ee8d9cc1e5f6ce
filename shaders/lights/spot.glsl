// SPDX-License-Identifier: MIT-0
#include "lib/elementary.glsl"
#include "lib/illumination.glsl"

// The share of a spot light that leaves it towards -l, axis the unit direction it shines in.
// With u = 1 - cos of the angle to the axis and ui, uo those of the inner and outer angle:
// ((uo - u) / (uo - ui))^exponent between them. Versines, because a cone of 0.1 degrees spans only
// 26 float steps of the cosine. Equal angles: a step.
float spotCone(vec3 l, vec3 axis, SpotLight p) {
    vec3 difference = -l - axis;
    float u = 0.5 * dot(difference, difference);
    float uo = versineOf(p.angleOuter);
    float ui = min(versineOf(p.angleInner), uo);
    if (u <= ui) {
        return 1.0;
    }
    if (u >= uo) {
        return 0.0;
    }
    return pow1m((u - ui) / (uo - ui), (uo - u) / (uo - ui), p.falloffExponent);
}

// At the light itself, where no direction leads to it, the point counts as straight in its beam.
Illumination spotLight(vec3 x, SpotLight p) {
    vec3 toLight = p.position - x;
    vec3 axis = safeNormalize(p.direction, vec3(0.0, -1.0, 0.0));
    float range = length(toLight);
    float attenuation = polynomialAttenuation(range, p.attenuationConstant, p.attenuationLinear,
        p.attenuationQuadratic);
    if (p.falloff == SPOT_LIGHT_FALLOFF_INVERSE_SQUARE) {
        attenuation = inverseSquareAttenuation(range, p.distanceMinimum);
    }
    Illumination i;
    i.l = safeNormalize(toLight, -axis);
    i.radiance = p.color * (p.intensity * attenuation * spotCone(i.l, axis, p));
    return i;
}
