// SPDX-License-Identifier: MIT-0

uniform float exposureFactor;

vec3 exposed(vec3 light) {
    return light * exposureFactor;
}
