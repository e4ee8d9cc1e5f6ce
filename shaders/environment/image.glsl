// SPDX-License-Identifier: MIT-0
#include "lib/sky_ray.glsl"

vec3 imageEnvironment(SkyRay o, ImageEnvironment p) {
    return o.picture * p.tint * p.intensity;
}
