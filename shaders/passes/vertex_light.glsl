// SPDX-License-Identifier: MIT-0
// A vertex as the lights find it, and the light that it sends to the viewer. The corners of one
// triangle may face the viewer and away from it, and only a fragment knows which side of the
// triangle is seen: both sides are lit.
#include "passes/surface_point.glsl"
#include "passes/storable.glsl"

out vec3 frontLight;
out vec3 backLight;

// `side`: 1.0 for the side of the normal, -1.0 for the other one.
Surface vertexSurface(float side) {
    Surface s;
    s.x = worldPosition;
    s.v = unitVector(toEye, vec3(0.0, 0.0, 1.0));
    s.range = length(toEye);
    s.n = unitTowardsViewer(side * worldNormal, s.v);
    s.t = tangentBeside(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    s.pixel = vec2(0.0);
    return s;
}

// Blending must not meet an infinity.
vec3 storableLight(vec3 light) {
    return vec3(storable(light.r), storable(light.g), storable(light.b));
}
