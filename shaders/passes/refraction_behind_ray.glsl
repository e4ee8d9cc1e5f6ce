// SPDX-License-Identifier: MIT-0
// What is seen through the middle of a pixel of a body.

vec3 seenBehind(Surface s, Passage w, vec3 across, vec3 up) {
    vec4 leaves = placeInClip(vec4(w.x, 1.0));
    vec3 place;
    if ((HAS_INSIDE && meets(placeInClip(vec4(s.x, 1.0)), leaves, place)) ||
        meets(leaves, placeInClip(vec4(w.leaving, 0.0)), place)) {
        return colorBehind(place.xy);
    }
    return distantLight(w.leaving, across, up);
}
