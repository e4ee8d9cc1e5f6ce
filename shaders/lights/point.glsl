// SPDX-License-Identifier: MIT-0
#include "lib/illumination.glsl"

// At the light itself, where no direction leads to it, it counts as straight above.
Illumination pointLight(vec3 x, PointLight p) {
    vec3 toLight = p.position - x;
    float range = metresTo(toLight);
    float attenuation = distanceAttenuation(range, p.falloff == POINT_LIGHT_FALLOFF_INVERSE_SQUARE,
        p.distanceMinimum, p.attenuationConstant, p.attenuationLinear, p.attenuationQuadratic,
        p.range);
    Illumination i;
    i.l = range > 0.0 ? toLight * (1.0 / range) : vec3(0.0, 1.0, 0.0);
    i.radiance = p.color * (p.intensity * attenuation);
    return i;
}
