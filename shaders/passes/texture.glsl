// SPDX-License-Identifier: MIT-0
// What images do to the surface.
#include "passes/texture_place.glsl"
#include "passes/surface.glsl"

in float surfaceSide;

// Whether the mesh's own front is seen.
float imageFront(Surface s) {
    return dot(worldNormal, s.n) < 0.0 ? -1.0 : 1.0;
}

// The direction of n, longer than 1e-9, towards the viewer; `fallback` where it is too long or no
// number, as images may have it.
vec3 seenDirection(vec3 n, vec3 v, vec3 fallback) {
    float length2 = dot(n, n);
    vec3 seen = n + max(MIN_NV * sqrt(length2) - dot(n, v), 0.0) * v;
    vec3 unit = seen * inversesqrt(dot(seen, seen));
    return length2 < 1e30 ? unit : fallback;
}

// The surface with a perturbed normal, longer than 1e-9.
Surface perturbed(Surface s, vec3 n) {
    s.n = seenDirection(n, s.v, s.n);
    s.t = tangentBeside(s.n, worldTangent);
    s.b = cross(s.n, s.t);
    return s;
}
