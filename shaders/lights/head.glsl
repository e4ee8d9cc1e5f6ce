// SPDX-License-Identifier: MIT-0
#include "lib/illumination.glsl"

// The offset arrives in world space. At the lamp itself it counts as straight above.
Illumination headLight(vec3 x, HeadLight p) {
    Illumination i;
    i.l = unitVector(p.offset - x, vec3(0.0, 1.0, 0.0));
    i.radiance = p.color * p.intensity;
    return i;
}
