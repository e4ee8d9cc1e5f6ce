// SPDX-License-Identifier: MIT-0
// The light of a whole environment on a surface whose reflectance is taken apart at each pixel, since
// images change it: a matte part, which is what is sent from light along the normal to 60 degrees, and
// one lobe, by the moments of the rest over half vectors at angles from HALF_NARROWEST on by factors
// (kappa: Banerjee et al. 2005, equation 4.4, as in lobe_fit.glsl).
#include "lib/directions.glsl"
#include "passes/ambient.glsl"
#include "passes/reflectance_limits.glsl"

const int HALF_RINGS = 9;
const int HALF_SECTORS = 3;
const float HALF_NARROWEST = 5e-4;
const float HALF_FACTOR = 2.6;
// How far the mean of a third of a ring is from the ring's middle, for what its own middle is: a lobe
// that one half vector sees alone is as wide as what that one stands for.
const float HALF_MEAN = 0.805;

vec3 fittedLight(Surface s, Model p) {
    vec3 matte = reflectanceLimited(ambientShare(s, p));
    vec3 r = 2.0 * dot(s.n, s.v) * s.n - s.v;
    vec3 color = vec3(0.0);
    vec3 shift = vec3(0.0);
    float spread = 0.0;
    float all = 0.0;
    float from = 0.0;
    float to = HALF_NARROWEST;
    for (int i = 0; i < HALF_RINGS; ++i) {
        float angle = sqrt(0.5 * (from * from + to * to));
        float area = 4.0 * PI * (sqr(sin(0.5 * to)) - sqr(sin(0.5 * from))) / float(HALF_SECTORS);
        for (int j = 0; j < HALF_SECTORS; ++j) {
            float turn = 2.0 * PI * (float(j) / float(HALF_SECTORS) + fract(0.618034 * float(i)));
            vec3 h = cos(angle) * s.n + sin(angle) * (cos(turn) * s.t + sin(turn) * s.b);
            float vh = dot(s.v, h);
            vec3 l = normalize(2.0 * vh * h - s.v);
            Directions d = directionsAt(s, l, s.v);
            if (vh > 0.0 && !IS_DARK(d)) {
                vec3 rest = max(reflectanceLimited(shadeModel(d, p)) - matte * max(d.nl, 0.0),
                    vec3(0.0));
                rest *= area * 4.0 * vh / PI;
                float weight = rest.r + rest.g + rest.b;
                color += rest;
                all += weight;
                shift += weight * HALF_MEAN * (l - r);
                spread += weight * 0.5 * dot(l - r, l - r);
            }
        }
        from = to;
        to *= HALF_FACTOR;
    }
    vec3 sum = matte * environmentOnMatte(environmentInside(s.n));
    if (!(all > 0.0)) {
        return sum;
    }
    shift /= all;
    float along = spread / all;
    vec3 across = shift - dot(shift, r) * r;
    float missingSquared = max(2.0 * along - along * along - dot(across, across), 0.0);
    float missing = clamp(missingSquared / (1.0 + safeSqrt(1.0 - missingSquared)), 1e-9, 0.9);
    float length = 1.0 - missing;
    float kappa = length * (3.0 - length * length) / (missing * (2.0 - missing));
    vec3 d = environmentInside(safeNormalize(r + shift, r));
    return sum + color * environmentSeenBy(d, log2(kappa));
}
