// SPDX-License-Identifier: MIT-0
// Out of focus without grain: a lobe that is as wide as a disc of the blur.

uniform float backgroundBlur; // half the width of the disc, in radians

vec3 backgroundRadiance(vec3 d, uint round, Environment p) {
    float kappa = 4.0 / max(backgroundBlur * backgroundBlur, 1e-6);
    return environmentSeenBy(environmentInside(d), log2(kappa));
}
