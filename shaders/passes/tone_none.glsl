// SPDX-License-Identifier: MIT-0

vec3 toneMapped(vec3 light) {
    return light;
}
