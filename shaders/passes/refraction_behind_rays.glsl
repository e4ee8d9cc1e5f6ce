// SPDX-License-Identifier: MIT-0
// What is seen through a pixel of a body: the mean over rays that are spread over the pixel, and over
// a pixel of the picture behind, which the body may enlarge. One ray meets a silhouette there or
// misses it, so that its edge would be as jagged as the picture's pixels.

// From -0.5 to 0.5, evenly spread for any number of rays (M. Roberts, The Unreasonable Effectiveness
// of Quasirandom Sequences, 2018).
vec2 rayPlace(int ray) {
    return fract((float(ray) + 0.5) * vec2(0.7548776662466927, 0.5698402909980532)) - 0.5;
}

// Moves a place of the picture in clip space by so many of the picture's pixels.
vec4 movedInPicture(vec4 x, vec2 pixels) {
    return x + vec4(2.0 * x.w * pixels / vec2(pictureSize()), 0.0, 0.0);
}

vec3 seenBehind(Surface s, Passage w, vec3 across, vec3 up) {
    vec3 leavesAcross = dFdx(w.x);
    vec3 leavesUp = dFdy(w.x);
    vec4 enters = placeInClip(vec4(s.x, 1.0));
    vec3 sum = vec3(0.0);
    int missed = 0;
    for (int i = 0; i < RAYS_BEHIND; ++i) {
        vec2 u = rayPlace(i);
        vec3 x = w.x + u.x * leavesAcross + u.y * leavesUp;
        vec3 d = w.leaving + u.x * across + u.y * up;
        vec4 begins = movedInPicture(enters, u.yx);
        vec4 leaves = movedInPicture(placeInClip(vec4(x, 1.0)), u.yx);
        vec4 ends = movedInPicture(placeInClip(vec4(d, 0.0)), u.yx);
        vec3 place;
        if ((HAS_INSIDE && meets(begins, leaves, place)) || meets(leaves, ends, place)) {
            sum += colorBehind(place.xy);
        } else {
            ++missed;
        }
    }
    if (missed > 0) {
        sum += float(missed) * distantLight(w.leaving, across, up);
    }
    return sum / float(RAYS_BEHIND);
}
