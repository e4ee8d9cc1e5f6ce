// SPDX-License-Identifier: MIT-0
// The direction of strands, for what lights each by itself.

out vec3 strandAlong; // in world space, of any length

void placeStrand(Shells p) {
    mat3 axes = objectAxes();
    vec3 above = shellOffset(p, min(shellHeight + 0.01, 1.0));
    vec3 below = shellOffset(p, max(shellHeight - 0.01, 0.0));
    strandAlong = axes * safeNormalize(above - below, strandNormal);
}
