// SPDX-License-Identifier: MIT-0
// How many rays a pixel has, where in it each begins, from its middle, and what one sees of the
// environment.

int raysOfPixel() {
    return int(environmentData[0].w);
}

vec2 placeInPixel(int ray) {
    return environmentPoint(uint(environmentData[0].z) + uint(ray), environmentSeed(9u)) - 0.5;
}

vec3 lightFar(vec3 d) {
    return environmentRadiance(environmentInside(d), unpackEnvironment(2));
}
