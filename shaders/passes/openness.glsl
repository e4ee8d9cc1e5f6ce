// SPDX-License-Identifier: MIT-0
// What a surface sees of its surroundings past its own object: a cone of free directions.

in vec4 openAround;

struct Openness {
    vec3 normal;    // unit
    vec3 direction; // about unit: the middle of what is free; the normal where nothing is hidden
    float share;    // 0 .. 1, weighted by the cosine
    float cone;     // the cosine of half the cone's angle
};

Openness opened; // set at the beginning of main

// The cosine of the angle between the cone's axis and the normal times the squared sine of half
// its angle is the share that a whole cone above the horizon has of the cosine's integral.
Openness openness(Surface s) {
    Openness o;
    o.normal = s.n;
    o.direction = s.n + openAround.xyz;
    o.share = clamp(openAround.w, 0.0, 1.0);
    o.cone = safeSqrt(1.0 - o.share / max(1.0 + dot(s.n, openAround.xyz), max(o.share, 1e-6)));
    return o;
}

// The surface as one that faces what is free.
Surface facingOpen(Surface s) {
    s.n = safeNormalize(opened.direction, s.n);
    return s;
}
