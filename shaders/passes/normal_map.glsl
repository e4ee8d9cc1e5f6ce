// SPDX-License-Identifier: MIT-0

// A normal map in tangent space: red along u, green along v (up), blue away from the surface (glTF
// 2.0, section 3.9.3). An image that is turned turns its slopes with it; the strength is a factor
// on them. From behind the relief is the other way round.
Surface normalMapped(Surface s, vec3 texel, int rows) {
    vec3 slope = 2.0 * texel - 1.0;
    vec2 across = objectData[rows].xy;
    vec2 up = objectData[rows + 1].xy;
    vec2 tilt = slope.x * across / max(length(across), 1e-30) +
        slope.y * up / max(length(up), 1e-30);
    tilt *= objectData[rows].w;
    return bent(s, imageFront(s) * tilt.x * s.t + surfaceSide * tilt.y * s.b +
        max(slope.z, 0.0) * s.n);
}
