// SPDX-License-Identifier: MIT-0
// Microfacet distributions and their v-cavity masking. sin2h : cos2h is sin^2 : cos^2 of the angle
// theta between the normal and the half vector, on any common scale. A D is in 1/sr and the
// integral of D cos over the hemisphere is 1; a lobe is 1 at theta = 0.
#include "lib/elementary.glsl"
#include "lib/math.glsl"

// Beckmann: D = exp(-tan^2 / alpha^2) / (pi alpha^2 cos^4), alpha the RMS slope.
// Cook and Torrance, A Reflectance Model for Computer Graphics, ACM TOG 1(1), 1982, with
// the 1/pi that their print leaves out. alpha 1e-4 .. 3. The cap only matters within 3e-8 rad of
// the horizon, where the exponential is 0 and 1/cos^4 would otherwise make 0 x infinity.
float beckmannDistribution(float sin2h, float cos2h, float alpha) {
    float tan2 = min(sin2h / max(cos2h, 1e-30), 1e15);
    float sec2 = 1.0 + tan2;
    float inverse2 = 1.0 / (alpha * alpha);
    return exp2(-1.4426950408889634 * (tan2 * inverse2)) * sec2 * sec2 * (inverse2 / PI);
}

// Trowbridge-Reitz (GGX): D = alpha^2 / (pi (cos^2 (alpha^2 - 1) + 1)^2).
// Trowbridge and Reitz, JOSA 65(5), 1975; Walter et al., EGSR 2007, equation 33. Written as
// alpha^2 r^2 / pi with r = 1 / (alpha^2 cos^2 + sin^2), which only adds positive terms.
float ggxDistribution(float sin2h, float cos2h, float alpha) {
    float r = (sin2h + cos2h) / (alpha * alpha * cos2h + sin2h);
    return alpha * alpha * r * r / PI;
}

// The width c3 with which the lobe (c3^2 / (cos^2 (c3^2 - 1) + 1))^2 of Trowbridge and Reitz falls
// to a half at theta = beta: c3^2 = (cos^2 beta - 1) / (cos^2 beta - sqrt 2), 0 < beta < pi/2.
// Blinn, SIGGRAPH 1977, distribution D3. The lobe is pi c3^2 times GGX of alpha = c3.
float trowbridgeReitzWidth(float beta) {
    float s = sin(beta);
    return s * inversesqrt(s * s + 0.41421356237309505);
}

// The exponent e with which cos^e falls to a half at theta = beta, e = -ln 2 / ln cos beta,
// 0 < beta < pi/2. Blinn 1977, distribution D1.
float phongExponent(float beta) {
    float s = sin(beta);
    return 0.69314718055994531 / (s * s * minusLnCosBySin2(s * s, 1.0 - s * s));
}

// Phong's lobe as a distribution: D = (e + 2) cos^e / (2 pi), e >= 0. Walter et al. 2007, equation
// 30.
float cosinePowerDistribution(float sin2h, float cos2h, float e) {
    return (e + 2.0) * powSC(sin2h, cos2h, e) / (2.0 * PI);
}

// The width of the Gaussian that falls to a half at theta = beta: beta / sqrt(ln 2). Blinn 1977,
// D2.
float gaussianWidth(float beta) {
    return 1.2011224087864498 * beta;
}

// The lobe e^(-(theta / width)^2) from 1 - cos theta, width > 0 in radians: Blinn 1977,
// distribution D2, which he takes from Torrance and Sparrow 1967; the Gaussian of Cook and Torrance
// 1982.
float gaussianLobe(float versine, float width) {
    float inverse = 1.0 / width;
    float angle2 = acos2(min(2.0 * versine, 2.0));
    return exp2(-1.4426950408889634 * (angle2 * inverse) * inverse);
}

// What the Gaussian lobe is divided by to be a distribution, the integral of lobe x cos over the
// hemisphere: pi width^2 gaussianShare(width^2); width up to 1.2.
float gaussianNormaliser(float width) {
    return PI * width * width * gaussianShare(width * width);
}

// Torrance and Sparrow's v-cavity masking and shadowing,
//   G = min(1, 2 (n.h)(n.v) / (v.h), 2 (n.h)(n.l) / (v.h)),
// divided by 4 (n.v): G / (4 n.v) = min(1 / (4 n.v), n.H / H.H min(1, n.l / n.v)) because
// n.h / v.h = 2 n.H / H.H. Torrance and Sparrow, JOSA 57(9), 1967; Cook and Torrance 1982.
// Finite at n.v = 0; nl > 0, nv > 0.
float vCavityVisibility(float nl, float nv, float nH, float HH) {
    float masked = nH / max(HH, 1e-30) * min(nl / max(nv, 1e-30), 1.0);
    return min(0.25 / max(nv, 1e-30), masked);
}
