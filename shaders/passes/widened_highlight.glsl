// SPDX-License-Identifier: MIT-0
// Highlights that are narrower than what the surface turns within a pixel are widened by that.

// Twice the variance of the normal under a pixel's Gaussian filter, whose own variance is 1 / (2 pi)
// of a pixel, and at most 0.18: what a square of the slope's width grows by. Y. Tokuyoshi and
// A. S. Kaplanyan, Improved Geometric Specular Antialiasing, I3D 2019.
float highlightSpread(vec3 n) {
    vec3 across = dFdx(n);
    vec3 up = dFdy(n);
    return min((dot(across, across) + dot(up, up)) / PI, 0.18);
}

// `alpha`: the slope of tiny mirrors, 0 .. 1.
float widenedSlope(float alpha, float spread) {
    return min(sqrt(alpha * alpha + spread), 1.0);
}

// Of a power of n.h, which is as wide as mirrors of the slope sqrt(2 / (m + 2)); m >= 0.
float widenedExponent(float m, float spread) {
    return 2.0 / min(2.0 / (m + 2.0) + spread, 1.0) - 2.0;
}

// Of a bell curve over the angle between n and h, exp(-(angle / width)^2).
float widenedAngle(float width, float spread) {
    return sqrt(width * width + spread);
}
