// SPDX-License-Identifier: MIT-0
// The point that a fragment shows, and where its colour goes.
#include "passes/surface_point.glsl"
#include "passes/storable.glsl"

in vec3 worldPosition;
centroid in vec3 worldNormal;
centroid in vec3 worldTangent;

layout(location = 0) out vec4 storedColor;

// The normal of the triangle itself, on the viewer's side.
vec3 faceNormal(vec3 v) {
    vec3 face = safeNormalize(cross(dFdx(worldPosition), dFdy(worldPosition)), v);
    return dot(face, v) < 0.0 ? -face : face;
}

// The interpolated normal, turned to the side that is seen whatever the winding of the triangle,
// so that a back side is shaded like a front. Vertices have unit normals or none (surface.vert).
vec3 shadingNormal(vec3 v) {
    vec3 face = cross(dFdx(worldPosition), dFdy(worldPosition));
    bool isBehind = (dot(worldNormal, face) < 0.0) != (dot(face, v) < 0.0);
    return unitTowardsViewer(isBehind ? -worldNormal : worldNormal, v);
}

Surface surface() {
    vec3 toEye = viewData[4].xyz - worldPosition;
    Surface s;
    s.x = worldPosition;
    s.range = sqrt(max(dot(toEye, toEye), 1e-30));
    s.v = toEye * (1.0 / s.range); // one division, also where a driver makes three of v / range
    s.n = shadingNormal(s.v);
    s.t = tangentAlong(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    s.pixel = gl_FragCoord.xy * viewData[4].w;
    return s;
}

void store(vec3 color, float alpha) {
    storedColor = vec4(storable(color.r), storable(color.g), storable(color.b), alpha);
}
