// SPDX-License-Identifier: MIT-0
// Strands that are combed to where an image says. Layers lie by their vertices, so it is read there.
#include "passes/object_axes.glsl"

vec2 vertexImagePlace(int rows) {
    vec4 across = objectData[rows];
    vec4 up = objectData[rows + 1];
    return vec2(dot(across.xy, uv) + across.z, dot(up.xy, uv) + up.z);
}

// The direction of a texel, along the object's axes: red along u, green along v (up), from -1 to 1.
// An image that is turned turns its directions with it. Behind it how much of it counts, which is
// nothing where the mesh has no direction of u or the image no number.
vec4 combedTowards(vec3 texel, int rows) {
    vec2 way = 2.0 * texel.xy - 1.0;
    float length2 = dot(way, way);
    vec2 across = objectData[rows].xy;
    vec2 up = objectData[rows + 1].xy;
    vec2 turned = way.x * inversesqrt(max(dot(across, across), 1e-30)) * across +
        way.y * inversesqrt(max(dot(up, up), 1e-30)) * up;
    vec3 t = worldTangent - dot(worldTangent, worldNormal) * worldNormal;
    float size2 = dot(t, t);
    if (!(length2 < 1e30 && size2 > 1e-6)) {
        return vec4(0.0);
    }
    t *= inversesqrt(size2);
    vec3 towards = turned.x * t + side * turned.y * cross(worldNormal, t);
    return vec4(towards * objectAxes(), objectData[rows].w);
}
