// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

float blinnF0Channel(Incidence i, BlinnF0Fresnel p, float F0) {
    return p.reflectanceF0 == BLINN_F0_FRESNEL_REFLECTANCE_F0_SCHLICK ? schlickReflectance(i, F0)
                                                                     : blinnF0Reflectance(i, F0);
}

// Fresnel's reflectance of the dielectric that reflects f0 facing the viewer, per channel.
vec3 blinnF0Fresnel(Incidence i, BlinnF0Fresnel p) {
    return vec3(blinnF0Channel(i, p, p.f0.x), blinnF0Channel(i, p, p.f0.y),
                blinnF0Channel(i, p, p.f0.z));
}

vec3 blinnF0FresnelTint(BlinnF0Fresnel p) {
    return p.color;
}
