// SPDX-License-Identifier: MIT-0
#include "lib/half_difference.glsl"

// Reads f from a file's table over the half and the difference angle.
vec3 measured(Directions d, Measured p) {
    return PI * d.nl * measuredFile(halfDifferencePlace(d), p);
}
