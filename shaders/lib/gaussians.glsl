// SPDX-License-Identifier: MIT-0
// Gaussians in the angle theta between the normal and the half vector, with the angle exactly and
// in two cheaper ways.
#include "lib/directions.glsl"
#include "lib/microfacet.glsl"

// The levels of an accuracy choice "angle", in the order in which every descriptor lists them: the
// exact angle is the one before these.
const int ANGLE_POLYNOMIAL = 1;
const int ANGLE_SMALL = 2;

// theta^2 by the level, from 1 - cos theta: a minimax polynomial up to theta = pi / 2, relative
// error 1.2e-4, or for small angles theta^2 = 2 (1 - cos theta).
float cheapSquaredAngle(int level, float versine) {
    if (level == ANGLE_POLYNOMIAL) {
        return versine * (1.999763966 + versine * (0.3403575718 + versine * (0.05738563836
            + versine * 0.06960269809)));
    }
    return 2.0 * versine;
}

// e^(-(theta / width)^2) by the level, from 1 - cos theta, width > 0.
float gaussianLobeBy(int level, float versine, float width) {
    if (level == ANGLE_POLYNOMIAL || level == ANGLE_SMALL) {
        float inverse = 1.0 / width;
        float angle2 = cheapSquaredAngle(level, versine);
        return exp2(-1.4426950408889634 * (angle2 * inverse) * inverse);
    }
    return gaussianLobe(versine, width);
}

// exp(-(theta_h / m)^2) by the level, m >= 0 the width in radians; 0 where n.h <= 0. m -> 0 is 1
// where h = n and else 0, which a rounding of the directions decides: like facets, a lobe is never
// narrower than slopeWidth() allows.
// R. L. Cook and K. E. Torrance, ACM TOG 1(1), 1982 (Blinn's Gaussian, 1977).
float gaussianHighlight(int level, Directions d, float m) {
    float lobe = gaussianLobeBy(level, upperVersine(d), slopeWidth(m));
    return d.nH > 0.0 ? lobe : 0.0;
}
