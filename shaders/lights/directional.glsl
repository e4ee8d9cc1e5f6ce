// SPDX-License-Identifier: MIT-0
#include "lib/illumination.glsl"

Illumination directionalLight(vec3 x, DirectionalLight p) {
    Illumination i;
    i.l = -unitVector(p.direction, vec3(0.0, -1.0, 0.0));
    i.radiance = p.color * p.intensity;
    return i;
}
