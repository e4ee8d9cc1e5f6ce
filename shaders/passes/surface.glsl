// SPDX-License-Identifier: MIT-0
// The point that a fragment shows, and where its colour goes.
#include "passes/surface_point.glsl"
#include "passes/storable.glsl"

in vec3 worldPosition;
in vec3 toEye;
centroid in vec3 worldNormal;
centroid in vec3 worldTangent;

layout(location = 0) out vec4 storedColor;

// The normal of the triangle itself, on the viewer's side; shorter, or zero, where a pixel is less
// than 1e-8 of its distance wide. By that distance, as pixels are small and large.
vec3 faceNormal(vec3 v) {
    float perMetre = 1.0 / sqrt(max(dot(toEye, toEye), 1e-30));
    vec3 face = cross(dFdx(toEye), dFdy(toEye));
    float scale = perMetre * perMetre;
    vec3 seen = face * (dot(face, v) < 0.0 ? -scale : scale);
    return seen * inversesqrt(max(dot(seen, seen), 1e-30));
}

bool isSeenFromBehind(vec3 v) {
    vec3 face = cross(dFdx(toEye), dFdy(toEye));
    return (dot(worldNormal, face) < 0.0) != (dot(face, v) < 0.0);
}

// The interpolated normal, turned to the side that is seen whatever the winding of the triangle,
// so that a back side is shaded like a front. Vertices have unit normals or none (surface.vert).
vec3 shadingNormal(vec3 v) {
    return unitTowardsViewer(isSeenFromBehind(v) ? -worldNormal : worldNormal, v);
}

Surface surface() {
    Surface s;
    s.x = worldPosition;
    s.range = sqrt(max(dot(toEye, toEye), 1e-30));
    s.v = toEye * (1.0 / s.range); // one division, also where a driver makes three of v / range
    s.n = shadingNormal(s.v);
    s.t = tangentBeside(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    s.pixel = gl_FragCoord.xy * viewData[4].w;
    return s;
}

void store(vec3 color, float alpha) {
    storedColor = vec4(storable(color.r), storable(color.g), storable(color.b), alpha);
}
