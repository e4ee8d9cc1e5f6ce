// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

// f = rho / pi, and what the slot adds. Lambert 1760.
vec3 lambert(Directions d, Lambert p) {
    return p.diffuseColor * d.nl + slotSpecular(d, p.specular);
}
