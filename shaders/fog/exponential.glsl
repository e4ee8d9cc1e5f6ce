// SPDX-License-Identifier: MIT-0
#include "lib/fog_ray.glsl"

// exp(-density x) at the distance x. Bouguer 1729.
float exponentialFog(FogRay ray, ExponentialFog p) {
    return exp(-p.density * ray.range);
}

vec3 exponentialFogColor(ExponentialFog p) {
    return p.color;
}
