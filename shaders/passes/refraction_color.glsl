// SPDX-License-Identifier: MIT-0
// What a transparent body shows of its surroundings: what passes through it, for each channel with
// a ray of its own where they are refracted differently, and what its surface mirrors.

vec3 shownThrough(Surface s, Refraction p) {
    vec3 r = 2.0 * dot(s.n, s.v) * s.n - s.v;
    vec3 mirrored = distantLight(r, dFdx(r), dFdy(r));
    vec3 sum = vec3(0.0);
    for (int channel = FIRST_CHANNEL; channel <= LAST_CHANNEL; ++channel) {
        Interface c = entering(s, channel);
        Passage w = passageFrom(s, c, p);
        vec3 passed = lightThrough(s, w) * leftShare(w.way, p);
        vec3 shown = mix(passed, mirrored, mirroredShare(c, p));
        vec3 chosen = FIRST_CHANNEL == LAST_CHANNEL
            ? vec3(1.0)
            : vec3(equal(ivec3(0, 1, 2), ivec3(channel)));
        sum += chosen * shown;
    }
    return sum;
}

// Half floats end at 65504; what is not a number is not light.
vec3 refracted(Surface s, vec3 shaded, float alpha, Refraction p) {
    vec3 shown = shownThrough(s, p);
    vec3 limited = vec3(storable(shown.r), storable(shown.g), storable(shown.b));
    return mix(limited, shaded, alpha);
}
