// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/fresnel.glsl"
#include "lib/gloss.glsl"
#include "lib/wave.glsl"

// The series S(g, x) over S(g, 0) as 2^(e y), y = x / (1 + g), and S(g, 0) (1 + g)^2: e and that
// change little wherever S counts. Along the axes go g / (g + 3), up to g = 1e4, beyond which
// neither changes, and y / (y + 3), up to 60, where nothing is left. No parameter has a part in it.
vec3 heTorranceSeriesEntry(vec2 u, HeTorrance p) {
    float g = 3e4 * u.x / (1e4 * (1.0 - u.x) + 3.0);
    float y = max(180.0 * u.y / (60.0 * (1.0 - u.y) + 3.0), 0.01); // the quotient at 0 is its limit
    float front = waveSeries(g, 0.0, 20.0, 8.0, 8.0);
    float fall = log2(waveSeries(g, y * (1.0 + g), 20.0, 8.0, 8.0) / front) / y;
    return vec3(fall, front * 8.6736173798840355e-19 * sqr(1.0 + g), 0.0);
}

float heTorranceTabled(HeTorrance p, float g, float x) {
    float y = x / (1.0 + g);
    vec3 entry = heTorranceSeries(vec2(1.0003 * g / (g + 3.0), 1.05 * y / (y + 3.0)), p);
    return waveTerm(entry.x * y) * entry.y / sqr(1.0 + g);
}

// The directional diffuse part of one wavelength without |F|^2, times pi (n.l):
//   G S D / (n.v), D = pi^2 tau^2 / (4 lambda^2) sum_m g^m e^-g / (m! m) e^(-x / m)
// with x = (pi tau / lambda)^2 |H - (n.H) n|^2 and g = (2 pi sigma / lambda (n.H))^2. The paper's G is
// (H.H / n.H)^2 for light of any polarisation, since (s_r.l)^2 + (p_r.l)^2 = |v x l|^2; it is
// multiplied into g, whose (n.H)^2 it cancels.
float heTorranceDiffuse(Directions d, HeTorrance p, float sigma2, float wavelength, float g) {
    float q = sqr(PI * p.tau / wavelength);
    float x = q * d.sin2h;
    float series = 0.0;
    if (p.series == HE_TORRANCE_SERIES_FULL) {
        series = waveSeries(g, x, 20.0, 8.0, 8.0);
    } else if (p.series == HE_TORRANCE_SERIES_MEDIUM) {
        series = waveSeries(g, x, 10.0, 4.5, 3.0);
    } else if (p.series == HE_TORRANCE_SERIES_TABLE) {
        series = heTorranceTabled(p, g, x);
    } else if (p.series == HE_TORRANCE_SERIES_LIMIT) {
        series = waveLimit(g, x);
    } else {
        series = waveSeries(g, x, 6.0, 3.3, 1.0);
    }
    float front = sqr(d.HH * 2.0 * PI / wavelength) * sigma2 * 0.25 * q;
    // The series comes times 2^60. `precise`: a compiler that moved the constant to other factors
    // would form products that are too small for a float.
    precise float part = front * series * 8.6736173798840355e-19;
    return part;
}

// The mirror part, e^-g of the light, spread over the disc that the light is seen as: a cone in
// 1 - r.v of the whole 1 that falls to 0 at `size`. (n.l) / (n.v) is shared between the two so that
// the part stays reciprocal; the paper's Delta / d omega.
float heTorranceMirror(Directions d, float size, float g) {
    float lobe = max(1.0 - d.versineRv / size, 0.0) / size;
    return exp2(-1.4426950408889634 * g) * lobe * 2.0 * d.nl / d.nH;
}

// rho_sp + rho_dd + rho_ud of He, Torrance, Sillion and Greenberg 1991. The slot's term is their
// |F|^2, (c_s |F_s|)^2 + (c_p |F_p|)^2 at half the angle between light and viewer, and alone knows
// how light is polarised.
vec3 heTorrance(Directions d, HeTorrance p) {
    float Kl = roughnessLoss(d.nl, d.sin2l, p.sigma0, p.tau);
    float Kv = roughnessLoss(d.nv, d.sin2v, p.sigma0, p.tau);
    float sigma2 = p.sigma0 * p.sigma0 * effectiveRoughness2(Kl, Kv);
    float Sl = d.nl * waveShadowing(d.nl, d.sin2l, p.sigma0, p.tau);
    float Sv = waveShadowing(d.nv, d.sin2v, p.sigma0, p.tau);
    // The mirror part is a Dirac delta under a smaller light; 0.01 degrees is the least.
    float size = versineOf(max(p.lightRadius, 1.7453293e-4));
    vec3 F = slotFresnel(halfIncidence(d), p.fresnel);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        float g = sqr(2.0 * PI * d.nH / p.wavelengths[i]) * sigma2;
        sum[i] += F[i] * Sl * Sv * heTorranceDiffuse(d, p, sigma2, p.wavelengths[i], g);
        if (p.lightRadius > 0.0) {
            sum[i] += F[i] * Sl * (Sv * d.nv) * heTorranceMirror(d, size, g);
        }
    }
    return p.diffuseColor * d.nl
        + glossed(sum, p.gloss, p.glossMode == HE_TORRANCE_GLOSS_MODE_LIMIT, d.nl);
}
