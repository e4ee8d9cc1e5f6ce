// SPDX-License-Identifier: MIT-0
// Fog by what it leaves at the vertices.

in float vertexFogShare;

// A sample beside the triangle, at its edge, blends to more than all or less than nothing.
vec3 fogged(Surface s, vec3 shaded, Fog p) {
    return mix(fogColor(p), shaded, clamp(vertexFogShare, 0.0, 1.0));
}
