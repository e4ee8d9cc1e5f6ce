// SPDX-License-Identifier: MIT-0
#include "lib/illumination.glsl"

Illumination directionalLight(vec3 x, DirectionalLight p) {
    Illumination i;
    i.l = -p.direction;
    i.radiance = p.color * p.intensity;
    return i;
}
