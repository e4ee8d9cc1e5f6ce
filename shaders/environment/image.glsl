// SPDX-License-Identifier: MIT-0
#include "lib/outlook.glsl"

vec3 imageEnvironment(Outlook o, ImageEnvironment p) {
    return o.picture * p.tint * p.intensity;
}
