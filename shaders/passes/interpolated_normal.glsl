// SPDX-License-Identifier: MIT-0
// The surface with the normal as blending the vertices' unit normals leaves it, shorter than 1.
#include "passes/surface.glsl"

// Samples beside the triangle, at its edges, would have longer ones, which no model expects: they
// get shorter than 1 too.
vec3 blendedNormal(vec3 v) {
    vec3 face = cross(dFdx(toEye), dFdy(toEye));
    vec3 n = worldNormal * clamp(1.5 - 0.5 * dot(worldNormal, worldNormal), 0.0, 1.0);
    bool isBehind = (dot(n, face) < 0.0) != (dot(face, v) < 0.0);
    return towardsViewer(isBehind ? -n : n, v);
}

Surface blendedSurface() {
    Surface s;
    s.x = worldPosition;
    s.v = unitVector(toEye, vec3(0.0, 0.0, 1.0));
    s.range = length(toEye);
    s.n = blendedNormal(s.v);
    s.t = tangentBeside(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    s.pixel = gl_FragCoord.xy * viewData[4].w;
    return s;
}
