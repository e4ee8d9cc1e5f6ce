// SPDX-License-Identifier: MIT-0
#include "lib/fog_ray.glsl"

// At the distance x, (end - x) / (end - start) in 0 .. 1; a step at the end when there is no way from
// start to end.
float linearFog(FogRay ray, LinearFog p) {
    float span = p.end - p.start;
    if (!(span > 0.0)) {
        return ray.range < p.end ? 1.0 : 0.0;
    }
    return clamp((p.end - ray.range) / span, 0.0, 1.0);
}

vec3 linearFogColor(LinearFog p) {
    return p.color;
}
