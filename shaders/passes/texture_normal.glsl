// SPDX-License-Identifier: MIT-0

// The direction of u in a surface of the normal n; shorter, or none, where the mesh's own is within
// a milliradian of n or has no length: it says nothing there, and the surface stays even along it.
vec3 imageTangent(vec3 n) {
    vec3 t = worldTangent - dot(worldTangent, n) * n;
    return t * inversesqrt(max(dot(t, t), 1e-6));
}

// A normal map in tangent space: red along u, green along v (up), blue away from the surface (glTF
// 2.0, section 3.9.3). An image that is turned turns its slopes with it; the strength is a factor
// on them. From behind the relief is the other way round. With 1e-6 there is always a direction,
// also where an image has none.
Surface normalMapped(Surface s, vec3 texel, int rows) {
    vec3 slope = 2.0 * texel - 1.0;
    vec2 across = objectData[rows].xy;
    vec2 up = objectData[rows + 1].xy;
    vec2 tilt = slope.x * inversesqrt(max(dot(across, across), 1e-30)) * across +
        slope.y * inversesqrt(max(dot(up, up), 1e-30)) * up;
    tilt *= objectData[rows].w;
    vec3 t = imageTangent(s.n);
    return perturbed(s, imageFront(s) * tilt.x * t + surfaceSide * tilt.y * cross(s.n, t) +
        max(slope.z, 1e-6) * s.n);
}
