// SPDX-License-Identifier: MIT-0
// Microfacet distributions D (1/sr, the integral of D cos over the hemisphere is 1) and masking.
// sin2h : cos2h is sin^2 : cos^2 of the angle between the normal and the half vector, on any
// common scale; alpha > 0 is the width of the distribution.
#include "lib/math.glsl"

// Beckmann: D = exp(-tan^2 / alpha^2) / (pi alpha^2 cos^4), alpha the RMS slope.
// Cook and Torrance, A Reflectance Model for Computer Graphics, ACM TOG 1(1), 1982, section 4, with
// the 1/pi that their print leaves out. alpha 1e-4 .. 3. The caps only matter within 1e-15 rad of
// the horizon, where the exponential is 0 and 1/cos^4 would otherwise make 0 x infinity.
float beckmannD(float sin2h, float cos2h, float alpha) {
    float tan2 = cos2h > 1e-30 * sin2h ? sin2h / cos2h : 1e30;
    float sec2 = 1.0 + min(tan2, 1e15);
    return exp2(-1.4426950408889634 * (tan2 / (alpha * alpha))) * sec2 * sec2
        / (PI * alpha * alpha);
}

// Trowbridge-Reitz (GGX): D = alpha^2 / (pi (cos^2 (alpha^2 - 1) + 1)^2).
// Trowbridge and Reitz, JOSA 65(5), 1975; Walter et al., EGSR 2007, equation 33. Written as
// alpha^2 r^2 / pi with r = 1 / (alpha^2 cos^2 + sin^2), which only adds positive terms.
float ggxD(float sin2h, float cos2h, float alpha) {
    float r = (sin2h + cos2h) / (alpha * alpha * cos2h + sin2h);
    return alpha * alpha * r * r / PI;
}

// Torrance and Sparrow's v-cavity masking and shadowing,
//   G = min(1, 2 (n.h)(n.v) / (v.h), 2 (n.h)(n.l) / (v.h)),
// divided by 4 (n.v): G / (4 n.v) = min(1 / (4 n.v), n.H / H.H min(1, n.l / n.v)) because
// n.h / v.h = 2 n.H / H.H. Torrance and Sparrow, JOSA 57(9), 1967; Cook and Torrance 1982,
// section 4. Finite at n.v = 0; nl > 0, nv > 0.
float vCavityVisibility(float nl, float nv, float nH, float HH) {
    float masked = nH / max(HH, 1e-30) * min(nl / max(nv, 1e-30), 1.0);
    return min(0.25 / max(nv, 1e-30), masked);
}
