// SPDX-License-Identifier: MIT-0
#include "lib/fog_ray.glsl"

// exp(-(density x)^2) at the distance x.
float exponentialSquaredFog(FogRay ray, ExponentialSquaredFog p) {
    float opticalDepth = p.density * ray.range;
    return exp(-opticalDepth * opticalDepth);
}

vec3 exponentialSquaredFogColor(ExponentialSquaredFog p) {
    return p.color;
}
