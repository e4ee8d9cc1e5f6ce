// SPDX-License-Identifier: MIT-0
// What an environment is asked.
#include "lib/math.glsl"

struct Outlook {
    vec3 d;       // unit, the way one looks; y is up
    vec3 picture; // what the environment's picture shows there, linear; white where it has none
};
