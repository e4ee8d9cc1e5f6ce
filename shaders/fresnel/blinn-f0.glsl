// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// Fresnel's reflectance of the dielectric that reflects f0 facing the viewer, per channel.
vec3 blinnF0Fresnel(Incidence i, BlinnF0Fresnel p) {
    return vec3(blinnF0Reflectance(i, p.f0.x), blinnF0Reflectance(i, p.f0.y),
                blinnF0Reflectance(i, p.f0.z));
}

vec3 blinnF0FresnelTint(BlinnF0Fresnel p) {
    return p.color;
}
