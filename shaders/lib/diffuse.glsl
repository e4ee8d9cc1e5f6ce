// SPDX-License-Identifier: MIT-0
// Matte reflection of rough surfaces, as pi f cos(theta_l) of a white surface unless a function
// says otherwise. No angle is ever made: with q = l.v - (n.l)(n.v),
//   cos(dphi) sin(theta_l) sin(theta_v) = q.
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/math.glsl"

// cos(dphi) sin(a) tan(b) for the larger angle a and the smaller one b of light and viewer: the
// smaller angle has the larger cosine. nl > 0, nv > 0; 1e-30 keeps flushed subnormals from 0/0.
float azimuthTerm(Directions d) {
    return (d.lv - d.nl * d.nv) / max(max(d.nl, d.nv), 1e-30);
}

// Oren and Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994, equation 30, with
// sigma2 the variance of the facets' angle in rad^2 and `offset` 0.33 or, to make up for the
// interreflection that is left out, 0.57 (their section 4.4).
float orenNayarQualitative(Directions d, float sigma2, float offset) {
    float A = 1.0 - 0.5 * sigma2 / (sigma2 + offset);
    float B = 0.45 * sigma2 / (sigma2 + 0.09);
    return d.nl * (A + B * max(azimuthTerm(d), 0.0));
}

// The complete model of the same paper (equations 27 to 29) without interreflection, divided by
// n.l; and in `bounce` the factor of 0.17 rho (n.l) of its interreflection. May be negative where
// both directions graze on opposite sides: the published fit is. xa >= xb are the angles in units
// of a right angle. sin a - xb^3 is 1 - xb^3 - (1 - sin a) where a is steep: neither digit is lost.
// 1 - |cos(dphi)|, which tan((a + b) / 2) may multiply by 1e8, comes from the sine of dphi: with
// H = l + v, sin(dphi) sin(theta_l) sin(theta_v) = (l.t)(H.b) - (l.b)(H.t).
float orenNayarFull(Directions d, float sigma2, OUT(float) bounce) {
    float xl;
    float yl;
    float xv;
    float yv;
    angXY(d.nl, d.sin2l, xl, yl);
    angXY(d.nv, d.sin2v, xv, yv);
    float xa = max(xl, xv);
    float xb = min(xl, xv);
    float yb = max(yl, yv);
    float ca = min(d.nl, d.nv);
    float sa = sqrt(max(d.sin2l, d.sin2v));
    float sb = sqrt(min(d.sin2l, d.sin2v));
    float q = d.lv - d.nl * d.nv;
    float cosPhi = clamp(q / max(sa * sb, 1e-30), -1.0, 1.0);
    float sin2Phi = sqr(d.lt * d.bH - d.lb * d.tH) / max(d.sin2l * d.sin2v, 1e-30);

    float fall = 1.0;
    if (q < 0.0) {
        fall = ca * ca > 0.5 ? 1.0 - xb * xb * xb / max(sa, 1e-30)
                             : (yb * (1.0 + xb + xb * xb) - ca * ca / (1.0 + sa)) / sa;
    }
    float spread = sigma2 / (sigma2 + 0.09);
    float C1 = 1.0 - 0.5 * sigma2 / (sigma2 + 0.33);
    float C2 = 0.45 * spread * fall * azimuthTerm(d);
    float C3 = 0.125 * spread * sqr(xa * xb);
    float tanHalf = (sa + sb) / max(d.nl + d.nv, 1e-30);
    bounce = sigma2 / (sigma2 + 0.13) * (1.0 - cosPhi * xb * xb);
    return C1 + C2 + min(sin2Phi, 1.0) / (1.0 + abs(cosPhi)) * C3 * tanHalf;
}

// pi/2 - 2/3 times 1/pi, 2/3 - 28/(15 pi): how far a rough surface's albedo falls at the normal
// and on average, per unit of roughness.
const float FUJII_FALL = 0.28779340921080620;
const float EON_AVERAGE_FALL = 0.07248821245692394;

// Fujii's qualitative model that keeps what it reflects in bounds, r = 0 .. 1:
//   A (1 + r s/t), A = 1 / (1 + (1/2 - 2/(3 pi)) r), s = q, t = max(n.l, n.v) where s > 0, else 1.
// Y. Fujii, A Tiny Improvement of Oren-Nayar Reflectance Model, 2013. As |l + v|^2 = 2 + 2 l.v,
// 1 + s = |l + v|^2 / 2 - (n.l)(n.v), where the first term is at least twice the second: no digit
// is lost where s is near -1. 1 + r s/t is ((t - r) + r (1 + s)) / t, so one division serves both.
float fujiiDiffuse(Directions d, float r) {
    float onePlusS = 0.5 * d.HH - d.nl * d.nv;
    float t = onePlusS > 1.0 ? max(max(d.nl, d.nv), 1e-30) : 1.0;
    return d.nl * ((t - r) + r * onePlusS) / (t + FUJII_FALL * r * t);
}

// q(c) = pi (1 - E(c)) / (A r): what one bounce of Fujii's model loses for light of cosine c,
// s2 = 1 - c^2. Portsmouth, Kutz and Hill, EON: A Practical Energy-Preserving Rough Diffuse BRDF,
// JCGT 14(1), 2025, with the common factor A r taken out, so that nothing is left of
// 0/0 at r = 0 or at the horizon. 0.9041... is pi/2 - 2/3.
float eonLoss(float c, float s2) {
    float x;
    float y;
    angXY(c, s2, x, y);
    float s = sqrt(s2);
    return 0.90412966012822988 * c * c / (1.0 + s) + s * (0.5 * PI * y + s * c)
        - (2.0 / 3.0) * s * c * (1.0 + s + s2) / (1.0 + s);
}

// q(c) without the angle: a polynomial with q(0) = 0, a minimax fit; the error is below 0.00103 of
// 0.904, the most that q is.
float eonLossFit(float c) {
    return c * (1.0252133915 + c * (0.2633991499 - c * (0.1645965690 + c * 0.2188611391)));
}

// The light that leaves after more than one bounce for the albedo rho (the same paper, equation
// 17), with the loss exactly or by its fit: rho_ms (1 - E_l)(1 - E_v) / (1 - E_avg),
// rho_ms = rho^2 E_avg / (1 - rho (1 - E_avg)).
vec3 eonBounces(Directions d, float r, vec3 rho, bool fits) {
    float A = 1.0 / (1.0 + FUJII_FALL * r);
    float average = A * (1.0 + EON_AVERAGE_FALL * r);
    vec3 kept = rho * rho * average / (vec3(1.0) - rho * (1.0 - average));
    float loss = fits ? eonLossFit(d.nl) * eonLossFit(d.nv)
                      : eonLoss(d.nl, d.sin2l) * eonLoss(d.nv, d.sin2v);
    return kept * (d.nl * A * r * loss / (PI * PI * (FUJII_FALL - EON_AVERAGE_FALL)));
}
