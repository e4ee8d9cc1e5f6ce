// SPDX-License-Identifier: MIT-0
// What a ray in the direction d sees of the environment. It changes by `across` and `up` from pixel
// to pixel: each round of samples looks elsewhere within.

vec3 distantLight(vec3 d, vec3 across, vec3 up) {
    Environment e = unpackEnvironment(2);
    uint first = uint(environmentData[0].z);
    int count = int(environmentData[0].w);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        vec2 u = environmentPoint(first + uint(i), environmentSeed(9u)) - 0.5;
        vec3 towards = safeNormalize(d + u.x * across + u.y * up, d);
        sum += environmentRadiance(environmentInside(towards), e);
    }
    return sum / float(count);
}
