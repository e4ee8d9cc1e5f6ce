// SPDX-License-Identifier: MIT-0
// What one ray of a pixel sees by a body of facets, in the channels that are followed.

vec3 shownTo(Surface s, Refraction p) {
    vec3 mirrored = lightFar(2.0 * dot(s.n, s.v) * s.n - s.v);
    vec3 sum = vec3(0.0);
    for (int channel = FIRST_CHANNEL; channel <= LAST_CHANNEL; ++channel) {
        Interface c = entering(s, channel);
        vec3 inside = safeNormalize(refractedRay(c, p), -s.v);
        vec3 shown = mix(lightOfFacets(s.x, inside, channel, p), mirrored, mirroredShare(c, p));
        vec3 chosen = FIRST_CHANNEL == LAST_CHANNEL
            ? vec3(1.0)
            : vec3(equal(ivec3(0, 1, 2), ivec3(channel)));
        sum += chosen * shown;
    }
    return sum;
}
