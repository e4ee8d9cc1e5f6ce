// SPDX-License-Identifier: MIT-0
// Without an environment there are no rounds of samples, and rays see the colour behind the objects.

int raysOfPixel() {
    return 1;
}

vec2 placeInPixel(int ray) {
    return vec2(0.0);
}

vec3 lightFar(vec3 d) {
    return objectData[REFRACTION_BACKGROUND].rgb;
}
