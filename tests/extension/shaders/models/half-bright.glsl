// SPDX-License-Identifier: GPL-3.0-or-later
#include "lib/directions.glsl"

vec3 halfBright(Directions d, HalfBright p) {
    if (p.look == HALF_BRIGHT_LOOK_PITCH_BLACK) {
        return vec3(0.0);
    }
    return vec3(0.5 * p.gain * d.cos2h / (d.sin2h + d.cos2h));
}
