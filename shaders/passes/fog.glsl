// SPDX-License-Identifier: MIT-0

FogRay fogRay(Surface s) {
    FogRay ray;
    ray.eye = viewData[4].xyz;
    ray.direction = -s.v;
    ray.range = s.range;
    return ray;
}

vec3 fogged(Surface s, vec3 shaded, Fog p) {
    return mix(fogColor(p), shaded, fogShare(fogRay(s), p));
}
