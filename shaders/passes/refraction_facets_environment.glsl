// SPDX-License-Identifier: MIT-0
// Where in its pixel a ray begins, from its middle, and what it sees of the environment.

vec2 placeInPixel() {
    uint round = uint(environmentData[0].z) / max(uint(environmentData[0].w), 1u);
    return environmentPoint(round, environmentSeed(9u)) - 0.5;
}

vec3 lightFar(vec3 d) {
    return environmentRadiance(environmentInside(d), unpackEnvironment(2));
}
