// SPDX-License-Identifier: MIT-0
#include "lib/fog_ray.glsl"
#include "lib/math.glsl"

vec3 foggedLine(vec3 color, Fog p) {
    vec3 way = linePoint - viewData[4].xyz;
    FogRay ray;
    ray.eye = viewData[4].xyz;
    ray.direction = safeNormalize(way, vec3(0.0, 0.0, -1.0));
    ray.range = length(way);
    return mix(fogColor(p), color, fogShare(ray, p));
}
