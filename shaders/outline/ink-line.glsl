// SPDX-License-Identifier: MIT-0
#include "lib/edge.glsl"

// The edges that Gooch et al. 1998, section 4.1, draw: boundaries, silhouettes and discontinuities.
vec2 inkLineOutline(Edge e, InkLineOutline p) {
    bool isEnd = e.ends && p.boundaries;
    bool isSilhouette = e.turns && !e.ends;
    bool isCrease = e.bend >= p.creaseAngle && !e.ends;
    return vec2(isEnd || isSilhouette ? p.width : 0.0, isEnd || isCrease ? p.creaseWidth : 0.0);
}

vec3 inkLineOutlineColor(InkLineOutline p) {
    return p.color;
}
