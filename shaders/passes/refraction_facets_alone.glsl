// SPDX-License-Identifier: MIT-0
// What a ray sees that leaves a body of facets at x after so many reflections: there is nothing in
// the scene but the body.

vec3 lightLeaving(vec3 x, vec3 d, int reflections) {
    return lightFar(d);
}
