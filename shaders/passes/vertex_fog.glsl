// SPDX-License-Identifier: MIT-0
// What fog leaves of the surface's colour at a vertex.
#include "lib/fog_ray.glsl"
#include "lib/math.glsl"

out float vertexFogShare;

void placeFog(Fog p) {
    FogRay ray;
    ray.eye = viewData[4].xyz;
    ray.direction = safeNormalize(-toEye, vec3(0.0, 0.0, -1.0));
    ray.range = length(toEye);
    vertexFogShare = fogShare(ray, p);
}
