// SPDX-License-Identifier: MIT-0

vec3 groundColored(vec3 shaded) {
    return shaded * objectData[GROUND].rgb;
}
