// SPDX-License-Identifier: MIT-0
// The light of the vertices, of the side that is seen.

in vec3 frontLight;
in vec3 backLight;

// A sample beside the triangle, at its edge, may blend to less than nothing.
vec3 blendedLight(Surface s) {
    vec3 face = cross(dFdx(toEye), dFdy(toEye));
    bool isBehind = (dot(worldNormal, face) < 0.0) != (dot(face, s.v) < 0.0);
    vec3 light = isBehind ? backLight : frontLight;
    return max(light, vec3(0.0));
}
