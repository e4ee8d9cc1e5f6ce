// SPDX-License-Identifier: MIT-0
// (1 - d)^e with c = 1 - d, the power that most highlights are, exactly and in two cheaper ways.
// d and c are both known without cancellation; e >= 0; 0 where c is not positive, also for e = 0.
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/lobes.glsl"

// The levels of an accuracy choice "power", in the order in which every descriptor lists them: the
// exact power is the one before these.
const int POWER_RATIONAL = 1;
const int POWER_GAUSSIAN = 2;

// A Gaussian on the sphere, e^(-e d): the power for small angles. The error is 0.29 / e at most
// where e >= 5. J. Wang et al., All-Frequency Rendering of Dynamic, Spatially-Varying Reflectance,
// ACM TOG 28(5), 2009.
float gaussianPower(float d, float c, float e) {
    return c > 0.0 ? exp2(-1.4426950408889634 * (e * d)) : 0.0;
}

// The power by the level of the choice. With r.v it is the lobe of B. T. Phong, Illumination for
// Computer Generated Pictures, CACM 18(6), 1975.
float powerLobe(int level, float d, float c, float e) {
    if (level == POWER_RATIONAL) {
        return schlickLobe(d, c, e);
    }
    if (level == POWER_GAUSSIAN) {
        return gaussianPower(d, c, e);
    }
    return pow1m(d, c, e);
}

// (n.h)^e by the level of the choice.
float halfPowerLobe(int level, Directions d, float e) {
    if (level == POWER_RATIONAL || level == POWER_GAUSSIAN) {
        return powerLobe(level, halfVersine(d), d.nh, e);
    }
    return blinnLobe(d.sin2h, d.cos2h, d.nH, e);
}
