// SPDX-License-Identifier: MIT-0

// What would arrive without shadows.
vec3 sent;

// The share of the light that arrives, by which what is behind is multiplied. Where no light would
// arrive anyway nothing is taken from it.
float arrivedShare(float arrived, float sent) {
    return sent > 0.0 ? clamp(arrived / sent, 0.0, 1.0) : 1.0;
}

vec3 groundDarkened(vec3 arrived, vec3 sent, float share) {
    vec3 left = vec3(arrivedShare(arrived.r, sent.r), arrivedShare(arrived.g, sent.g),
        arrivedShare(arrived.b, sent.b));
    return mix(vec3(1.0), left, share);
}
