// SPDX-License-Identifier: MIT-0
// Light as a wave on a randomly rough surface, for heights of about a wavelength: the terms of
// He, Torrance, Sillion and Greenberg, A Comprehensive Physical Model for Light Reflection,
// SIGGRAPH 1991. Heights are Gaussian with the RMS sigma0 and the autocorrelation length tau, both
// in micrometres; c and s2 are the cosine and the squared sine of a direction with the normal.
#include "lib/elementary.glsl"
#include "lib/masking.glsl"
#include "lib/math.glsl"

// How much of a rough surface a flat direction misses, the paper's
// K = tan erfc(tau cot / (2 sigma0)). At most 1e15: a direction in the surface itself.
float roughnessLoss(float c, float s2, float sigma0, float tau) {
    float s = sqrt(s2);
    float a = min(0.5 * tau * c / max(sigma0 * s, 1e-30), 1e15);
    return min(s / max(c, 1e-30), 1e15) * erfcOf(a);
}

// (sigma / sigma0)^2 of the surface that both directions see: sigma = sigma0 / sqrt(1 + z^2) with
// sqrt(pi / 2) z = (Kl + Kv) e^(-z^2 / 2) / 4, the paper's z0 / sigma0, so that z^2 = W((Kl + Kv)^2
// / (8 pi)) with Lambert's W.
float effectiveRoughness2(float Kl, float Kv) {
    return 1.0 / (1.0 + lambertW(sqr(Kl + Kv) / (8.0 * PI)));
}

// The shadowing of one direction over its cosine, (1 - erfc(a) / 2) / (c (1 + Lambda)) with
// a = tau cot / (2 sigma0), the paper's S with Smith's Lambda. Finite at the horizon while
// sigma0 > 0.
float waveShadowing(float c, float s2, float sigma0, float tau) {
    float a = min(0.5 * tau * c / max(sigma0 * sqrt(s2), 1e-30), 1e15);
    float unmasked = beckmannUnmasked(c, s2, 2.0 * sigma0 / tau);
    return (1.0 - 0.5 * erfcOf(a)) / max(unmasked, 1e-30);
}

// ln of g^m e^-g / m! times sqrt(2 pi), without the difference of large numbers that it is made of:
// -(m ln(m / g) - m + g) - stirlingError(m) - ln(m) / 2, the bracket through atanh near m = g
// (Loader, Fast and Accurate Computation of Binomial Probabilities, 2000). m >= 1, g > 0.
float poissonLog(float m, float g) {
    float v = (m - g) / (m + g);
    float farther = 0.69314718055994531 * m * log2(m / g) - (m - g);
    float nearer = v * ((m - g) + 2.0 * m * atanhExcess(min(v * v, 0.12)));
    float deviance = abs(v) < 1.0 / 3.0 ? nearer : farther;
    return -deviance - stirlingError(m) - 0.34657359027997265 * log2(m);
}

// 2^(exponent + 60). The sum is formed only where it is exact; what devices take as 0 because a
// float has too few digits for it begins at 1e-56 in place of 1e-38.
float waveTerm(float exponent) {
    bool tiny = exponent < -60.0;
    return exp2(tiny ? exponent + 60.0 : exponent) * (tiny ? 1.0 : 1152921504606846976.0);
}

// 2^60 times the sum over m >= 1 of g^(m-1) e^(-g - x / m) / (m! m), the series of the paper's D
// over g; the factor keeps sums that a large factor brings back into a float's range. The terms
// have one peak, at m = g e^(W(2 x / g^2) / 2), of about the width (1 / m + 2 x / m^3)^(-1/2). What
// lies within `reach` widths and `spare` terms of it is summed: every term while the peak is low,
// where the series begins, and else about 2 nodes + 1 in even steps, which for a smooth peak is as
// exact. All terms are positive; g, x >= 0.
float waveSeries(float g, float x, float nodes, float reach, float spare) {
    float gg = max(g, 1e-15);
    float W = lambertW(min(2.0 * x / (gg * gg), 1e30));
    float peak = max(gg * exp2(0.72134752044448170 * W), 1.0);
    float width = inversesqrt(1.0 / peak + 2.0 * x / (peak * peak * peak));
    float stride = peak < 40.0 ? 1.0 : max(ceil(reach * width / nodes), 1.0);
    float middle = floor(peak + 0.5);
    float above = ceil((reach * width + spare) / stride);
    int first = -int(min(above, floor((middle - 2.0) / stride)));
    int last = int(above);
    float sum = stride > 1.0 ? 0.0 : waveTerm(-1.4426950408889634 * (g + x));
    for (int j = first; j <= last; ++j) {
        float m = middle + stride * float(j);
        float exponent = poissonLog(m, gg) - x / m;
        sum += stride * 0.39894228040143268 * waveTerm(1.4426950408889634 * exponent) / (m * gg);
    }
    return sum;
}

// The same times 2^60 without a search for the terms that count: twelve terms where g is small, and
// else the logarithm of the sum, the mean of e^(-x / m) / m over a Poisson distribution of m, to
// second order in 1 / g, which is positive and falls with y = x / g everywhere:
//   -y + (1 - 2 y + y^2 / 2) / g + (3 / 2 - 7 y + 5 y^2 - 5 y^3 / 6) / g^2 - ln g^2
// Within 1.4 % of the largest value at that g, and within 0.02 % from g = 30 on; of the value itself
// within 2.2 % down to a tenth of the largest, and 5.7 % down to a hundredth. g, x >= 0.
float waveLimit(float g, float x) {
    float few = min(g, 8.0);
    float weight = 1.0;
    float sum = waveTerm(-1.4426950408889634 * (few + x));
    for (int i = 2; i <= 12; ++i) {
        float m = float(i);
        weight *= few / m;
        sum += weight * waveTerm(-1.4426950408889634 * (few + x / m)) / m;
    }
    float many = max(g, 5.0);
    float y = min(x / many, 1e4); // nothing is left beyond
    float first = 1.0 + y * (0.5 * y - 2.0);
    float second = 1.5 - y * (7.0 - y * (5.0 - 0.83333333333333333 * y));
    float exponent = (first + second / many) / many - y;
    float limit = waveTerm(1.4426950408889634 * exponent) / (many * many);
    return mix(sum, limit, clamp((g - 5.0) / 3.0, 0.0, 1.0));
}
