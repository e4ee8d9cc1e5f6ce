// SPDX-License-Identifier: MIT-0
// Reflectance of a smooth surface.
#include "lib/incidence.glsl"
#include "lib/math.glsl"

// F0 + (1 - F0)(1 - c)^5 for one channel; F0 and the result 0 .. 1.
// Schlick, An Inexpensive BRDF Model for Physically-based Rendering, CGF 13(3), 1994, equation 15.
float schlickReflectance(Incidence i, float F0) {
    return F0 + (1.0 - F0) * pow5(i.versine);
}

// Reflectance of a dielectric for light polarised across (Rs) and in (Rp) the plane of incidence,
// etaI the index on the side of the light, etaT on the other; both > 0. With eta = etaT / etaI and
// g^2 = eta^2 - 1 + c^2:
//   Rs = ((g - c) / (g + c))^2          Rp = Rs ((c (g + c) - 1) / (c (g - c) + 1))^2
// Fresnel's equations in the form of Blinn, SIGGRAPH 1977. Written with g - c = (eta^2 - 1)/(g + c)
// and c (g +- c) -+ 1 = c g -+ sin^2, so an index close to 1 keeps its digits. Limits: no
// reflection for equal indices; total reflection where g^2 <= 0. Near the critical angle g^2 is a
// small difference: of eta^2 - 1 and -c^2, or of eta^2 and sin^2, whichever are the smaller terms.
void dielectricReflectances(Incidence i, float etaI, float etaT, OUT(float) Rs, OUT(float) Rp) {
    float eta2m1 = (etaT - etaI) * (etaT + etaI) / (etaI * etaI);
    float s2 = sin2Incidence(i);
    float s = sqrt(s2);
    float g2 = eta2m1 + i.c * i.c;
    if (s2 < 0.5) {
        g2 = (etaT - etaI * s) * (etaT + etaI * s) / (etaI * etaI);
    }
    Rs = g2 <= 0.0 ? 1.0 : 0.0;
    Rp = Rs;
    if (eta2m1 == 0.0) {
        Rs = 0.0;
        Rp = 0.0;
    } else if (g2 > 0.0) {
        float g = sqrt(g2);
        float w = (i.c * g - s2) / (i.c * g + s2);
        Rs = min(sqr(eta2m1 / sqr(g + i.c)), 1.0); // at c = 0 rounding may pass 1
        Rp = Rs * w * w;
    }
}

// Strauss's Fresnel weight, 0 at x = 0 and 1 at x = 1:
//   F(x) = (1 / (x - kf)^2 - 1 / kf^2) / (1 / (1 - kf)^2 - 1 / kf^2)
// Strauss, A Realistic Lighting Model for Computer Animators, IEEE CG&A 10(6), 1990. x is an angle
// in right angles and y = 1 - x; kf > 1. Multiplied out, so that no reciprocals are subtracted.
float straussFresnel(float x, float y, float kf) {
    return x * (2.0 * kf - x) * sqr((kf - 1.0) / (y + kf - 1.0)) / (2.0 * kf - 1.0);
}

// Strauss's shadowing, 1 at x = 0 and 0 at x = 1, y = 1 - x, ks > 1:
//   G(x) = (1 / (1 - ks)^2 - 1 / (x - ks)^2) / (1 / (1 - ks)^2 - 1 / ks^2)
// The same paper; multiplied out.
float straussShadowing(float y, float ks) {
    return ks * ks * y * (y + 2.0 * (ks - 1.0)) / ((2.0 * ks - 1.0) * sqr(y + ks - 1.0));
}
