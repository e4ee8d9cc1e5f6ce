// SPDX-License-Identifier: MIT-0
// There is nothing in the scene that could be seen through the body.

vec3 seenBehind(Surface s, Passage w, vec3 across, vec3 up) {
    return distantLight(w.leaving, across, up);
}
