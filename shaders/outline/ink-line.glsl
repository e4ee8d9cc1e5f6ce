// SPDX-License-Identifier: MIT-0
#include "lib/edge.glsl"

// The edges that Gooch et al. 1998, section 4.1, draw: boundaries, silhouettes and discontinuities.
vec2 inkLineOutline(Edge e, InkLineOutline p) {
    bool isEnd = e.open && p.boundaries;
    bool isSilhouette = e.silhouette && !e.open;
    bool isCrease = e.dihedral >= p.creaseAngle && !e.open;
    return vec2(isEnd || isSilhouette ? p.width : 0.0, isEnd || isCrease ? p.creaseWidth : 0.0);
}

vec3 inkLineOutlineColor(InkLineOutline p) {
    return p.color;
}
