// SPDX-License-Identifier: MIT-0
// What a ray sees that leaves a body of facets at x after so many reflections: one that is not
// reflected goes on to what was drawn before, the others see what is far.

vec3 lightLeaving(vec3 x, vec3 d, int reflections) {
    vec3 place;
    bool isMet = reflections == 0 &&
        meets(placeInClip(vec4(x, 1.0)), placeInClip(vec4(d, 0.0)), place);
    return isMet ? colorBehind(place.xy) : lightFar(d);
}
