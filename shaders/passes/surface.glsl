// SPDX-License-Identifier: MIT-0
// The point that a fragment shows, and where its colour goes.
#include "passes/blocks.glsl"
#include "lib/directions.glsl"
#include "lib/math.glsl"
#include "passes/storable.glsl"

layout(std140) uniform SceneBlock {
    vec4 sceneData[SCENE_VEC4S];
};

in vec3 worldPosition;
in vec3 worldNormal;
in vec3 worldTangent;

layout(location = 0) out vec4 storedColor;

// The smallest n.v that is shaded. Interpolated normals of a coarse mesh point away from the
// viewer near its outline, where every model is 0 and black pixels would line it; they are bent
// towards the viewer to 0.6 degrees above the horizon.
const float LEAST_NV = 0.01;

struct Surface {
    vec3 x;         // in world space
    vec3 v;         // unit, to the eye
    float range;    // metres from the eye
    vec3 n;         // unit normal on the viewer's side
    vec3 t;         // unit tangents, orthogonal to n and to each other
    vec3 b;
    vec2 pixel;     // of the picture, whatever the target's fineness
};

// The normal of the triangle itself, on the viewer's side.
vec3 faceNormal(vec3 v) {
    vec3 face = safeNormalize(cross(dFdx(worldPosition), dFdy(worldPosition)), v);
    return dot(face, v) < 0.0 ? -face : face;
}

vec3 towardsViewer(vec3 n, vec3 v) {
    float lack = LEAST_NV - dot(n, v);
    return lack > 0.0 ? normalize(n + lack * v) : n;
}

// The interpolated normal, turned to the side that is seen whatever the winding of the triangle,
// so that a back side is shaded like a front.
vec3 shadingNormal(vec3 v) {
    vec3 face = cross(dFdx(worldPosition), dFdy(worldPosition));
    vec3 n = unitVector(worldNormal, v);
    bool isBehind = (dot(n, face) < 0.0) != (dot(face, v) < 0.0);
    return towardsViewer(isBehind ? -n : n, v);
}

Surface surface() {
    vec3 toEye = viewData[4].xyz - worldPosition;
    Surface s;
    s.x = worldPosition;
    s.v = unitVector(toEye, vec3(0.0, 0.0, 1.0));
    s.range = length(toEye);
    s.n = shadingNormal(s.v);
    s.t = tangentAlong(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    s.pixel = gl_FragCoord.xy * viewData[4].w;
    return s;
}

Directions directionsAt(Surface s, vec3 l, vec3 v) {
    Directions d = directions(s.n, s.t, s.b, l, v);
    d.pixel = s.pixel;
    return d;
}

void store(vec3 color, float alpha) {
    storedColor = vec4(storable(color.r), storable(color.g), storable(color.b), alpha);
}
