// SPDX-License-Identifier: MIT-0
#include "lib/elementary.glsl"
#include "lib/fog_ray.glsl"

// exp(-T), T the integral of the density along the way to the surface: `density` up to the height
// `base`, above it density exp(-(y - base) / thickness). Both parts have a closed form, so no step
// along the ray is needed. 1e15 m is far enough for anything and keeps products finite.
float heightFog(FogRay ray, HeightFog p) {
    float range = min(ray.range, 1e15);
    float rise = ray.direction.y * range;
    float low = ray.eye.y + min(rise, 0.0);
    float span = abs(rise);
    float below = low < p.base ? 1.0 : 0.0;
    if (span > 0.0) {
        below = clamp((p.base - low) / span, 0.0, 1.0);
    }
    float steepness = 1.0 / max(p.thickness, 1e-6);
    float lift = max(low - p.base, 0.0) * steepness;
    float above = exp(-lift) * meanOfExp((1.0 - below) * span * steepness);
    return exp(-p.density * range * (below + (1.0 - below) * above));
}

vec3 heightFogColor(HeightFog p) {
    return p.color;
}
