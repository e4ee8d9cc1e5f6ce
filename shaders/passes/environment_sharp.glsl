// SPDX-License-Identifier: MIT-0

vec3 backgroundRadiance(vec3 d, uint round, Environment p) {
    return environmentRadiance(environmentInside(d), p);
}
