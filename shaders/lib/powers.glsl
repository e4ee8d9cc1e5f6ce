// SPDX-License-Identifier: MIT-0
// (1 - d)^e with c = 1 - d, the power that most highlights are, exactly and in three cheaper ways.
// d and c are both known without cancellation; e >= 0; 0 where c is not positive, also for e = 0.
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/lobes.glsl"

// The levels of an accuracy choice "power", in the order in which every descriptor lists them: the
// exact power is the one before these.
const int POWER_ROUNDED = 1;
const int POWER_RATIONAL = 2;
const int POWER_GAUSSIAN = 3;

// The power of a cosine as it is rounded, by GLSL's own: off by e times the rounding.
float roundedPower(float c, float e) {
    return c > 0.0 ? pow(min(c, 1.0), e) : 0.0;
}

// A Gaussian on the sphere, e^(-e d): the power for small angles. The error is 0.29 / e at most
// where e >= 5. J. Wang et al., All-Frequency Rendering of Dynamic, Spatially-Varying Reflectance,
// ACM TOG 28(5), 2009.
float gaussianPower(float d, float c, float e) {
    return c > 0.0 ? exp2(-1.4426950408889634 * (e * d)) : 0.0;
}

// The power by the level of the choice.
float powerLobe(int level, float d, float c, float e) {
    if (level == POWER_ROUNDED) {
        return roundedPower(c, e);
    }
    if (level == POWER_RATIONAL) {
        return schlickLobe(d, c, e);
    }
    if (level == POWER_GAUSSIAN) {
        return gaussianPower(d, c, e);
    }
    return pow1m(d, c, e);
}

// (r.v)^e by the level of the choice, with r.v = 2 (n.l)(n.v) - l.v where it may be rounded: the
// lobe of B. T. Phong, Illumination for Computer Generated Pictures, CACM 18(6), 1975.
float mirrorPowerLobe(int level, Directions d, float e) {
    if (level == POWER_ROUNDED) {
        return roundedPower(2.0 * d.nl * d.nv - d.lv, e);
    }
    return powerLobe(level, d.versineRv, d.rv, e);
}

// (n.h)^e by the level of the choice. It is not rounded: h is a quotient, which loses more digits the
// more light and viewer graze the surface.
float halfPowerLobe(int level, Directions d, float e) {
    if (level == POWER_RATIONAL || level == POWER_GAUSSIAN) {
        return powerLobe(level, halfVersine(d), d.nh, e);
    }
    return blinnLobe(d.sin2h, d.cos2h, d.nH, e);
}

// 1 - (1 - y)^5 for y = 0 .. 1, multiplied out so that a small y keeps its digits.
float fifthRise(float y) {
    return y * (5.0 - y * (10.0 - y * (10.0 - y * (5.0 - y))));
}
