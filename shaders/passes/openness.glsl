// SPDX-License-Identifier: MIT-0
// What a surface sees of its surroundings past its own object: a cone of free directions.

centroid in vec3 openDirection;
centroid in vec2 openShares;

struct Openness {
    vec3 normal;    // of the mesh, whatever images make of it, on the viewer's side
    vec3 direction; // unit: the middle of what is free; the normal where nothing is hidden
    float share;    // 0 .. 1, weighted by the cosine
    float cone;     // the cosine of half the cone's angle
};

Openness opened; // set at the beginning of main

// The cosine of the angle between the cone's axis and the normal times the squared sine of half
// its angle is the share that a whole cone above the horizon has of the cosine's integral.
Openness openness(Surface s) {
    bool isBehind = isSeenFromBehind(s.v);
    Openness o;
    o.normal = safeNormalize(isBehind ? -worldNormal : worldNormal, s.n);
    o.direction = isBehind ? o.normal : safeNormalize(openDirection, o.normal);
    o.share = clamp(isBehind ? openShares.y : openShares.x, 0.0, 1.0);
    float most = max(dot(o.normal, o.direction), max(o.share, 1e-6));
    o.cone = safeSqrt(1.0 - o.share / most);
    return o;
}

// The surface as one that faces what is free.
Surface facingOpen(Surface s) {
    s.n = safeNormalize(s.n + (opened.direction - opened.normal), s.n);
    return s;
}
