// SPDX-License-Identifier: MIT-0
// What images do to the surface.
#include "passes/image_place.glsl"
#include "passes/surface.glsl"

in float surfaceSide;

// Whether the mesh's own front is seen.
float imageFront(Surface s) {
    return dot(worldNormal, s.n) < 0.0 ? -1.0 : 1.0;
}

// The surface with another normal.
Surface bent(Surface s, vec3 n) {
    s.n = towardsViewer(safeNormalize(n, s.n), s.v);
    s.t = tangentAlong(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    return s;
}
