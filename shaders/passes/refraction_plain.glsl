// SPDX-License-Identifier: MIT-0
// Where there is no environment, a ray that meets nothing sees the colour behind the objects.

vec3 distantLight(vec3 d, vec3 across, vec3 up) {
    return objectData[REFRACTION_BACKGROUND].rgb;
}
