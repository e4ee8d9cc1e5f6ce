// SPDX-License-Identifier: GPL-3.0-or-later
#include "lib/incidence.glsl"

vec3 velvetSheen(Incidence i, VelvetSheen p) {
    return p.tint * pow(i.versine, p.width);
}

float velvetSheenShare(VelvetSheen p) {
    return 1.0 / (1.0 + p.width);
}
