// SPDX-License-Identifier: MIT-0
// How what a pass returns and the picture before it are put together, in the pass's colours.

vec3 pictureOver(vec3 below, vec3 above) {
    return above;
}

vec3 pictureMultiply(vec3 below, vec3 above) {
    return below * above;
}

vec3 pictureScreen(vec3 below, vec3 above) {
    return below + above - below * above;
}

vec3 pictureAdd(vec3 below, vec3 above) {
    return min(below + above, vec3(1.0));
}
