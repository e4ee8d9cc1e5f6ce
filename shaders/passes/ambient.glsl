// SPDX-License-Identifier: MIT-0

// The model's diffuse share: light along the normal, seen from 60 degrees, where no lobe around
// the mirror direction contributes.
vec3 ambientShare(Surface s, Model p) {
    vec3 v = 0.5 * s.n + sqrt(0.75) * s.t;
    return CUT_AT_ZERO(shadeModel(directionsAt(s, s.n, v), p));
}
