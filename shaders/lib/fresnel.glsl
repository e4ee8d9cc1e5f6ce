// SPDX-License-Identifier: MIT-0
// Reflectance of a smooth surface.
#include "lib/incidence.glsl"
#include "lib/math.glsl"
#include "lib/refraction.glsl"

// F0 + (1 - F0)(1 - c)^5 for one channel; F0 and the result 0 .. 1.
// Schlick, An Inexpensive BRDF Model for Physically-based Rendering, CGF 13(3), 1994, equation 15.
float schlickReflectance(Incidence i, float F0) {
    return F0 + (1.0 - F0) * pow5(i.versine);
}

// Schlick's reflectance from the cosine alone.
float fresnelSchlick(float c, float F0) {
    return schlickReflectance(incidenceOf(c), F0);
}

// Reflectance of a dielectric for light polarised across (Rs) and in (Rp) the plane of incidence,
// etaI the index on the side of the light, etaT on the other; both > 0. With eta = etaT / etaI and
// g^2 = eta^2 - 1 + c^2:
//   Rs = ((g - c) / (g + c))^2          Rp = Rs ((c (g + c) - 1) / (c (g - c) + 1))^2
// Fresnel's equations in the form of Blinn, SIGGRAPH 1977. Written with g - c = (eta^2 - 1)/(g + c)
// and c (g +- c) -+ 1 = c g -+ sin^2, so an index close to 1 keeps its digits. Limits: no
// reflection for equal indices; total reflection where g^2 <= 0.
void dielectricReflectances(Incidence i, float etaI, float etaT, OUT(float) Rs, OUT(float) Rp) {
    float eta2m1 = (etaT - etaI) * (etaT + etaI) / (etaI * etaI);
    float s2 = sin2Incidence(i);
    float g2 = refractedG2(i, etaI, etaT);
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

// Fresnel's reflectance of a dielectric for ordinary light, the mean of Rs and Rp, from the cosine
// c of the angle of incidence and eta, the index beyond the surface over that on the light's side.
// 1 beyond the critical angle. c 0 .. 1, eta > 0.
float fresnelDielectric(float c, float eta) {
    float Rs;
    float Rp;
    dielectricReflectances(incidenceOf(c), 1.0, eta, Rs, Rp);
    return 0.5 * (Rs + Rp);
}

// Schlick's reflectance of a dielectric, F0 = ((etaT - etaI) / (etaT + etaI))^2. From the denser
// side the rise is that at the angle outside, and all is reflected beyond the critical angle.
// Nothing for equal indices.
float schlickDielectric(Incidence i, float etaI, float etaT) {
    float F0 = sqr((etaT - etaI) / (etaT + etaI));
    float versine = i.versine;
    if (etaT < etaI) {
        versine = 1.0 - min(safeSqrt(refractedG2(i, etaI, etaT)) * etaI / etaT, 1.0);
    }
    return F0 > 0.0 ? F0 + (1.0 - F0) * pow5(versine) : 0.0;
}

// The same with (1 - c)^5 fitted by 2^(-(5.55473 c + 6.98316) c) (Karis, Real Shading in Unreal
// Engine 4, SIGGRAPH 2013 course). Beyond the critical angle c counts as 0.
float exponentialDielectric(Incidence i, float etaI, float etaT) {
    float F0 = sqr((etaT - etaI) / (etaT + etaI));
    float c = i.c;
    if (etaT < etaI) {
        c = min(safeSqrt(refractedG2(i, etaI, etaT)) * etaI / etaT, 1.0);
    }
    return F0 > 0.0 ? F0 + (1.0 - F0) * exp2(-(5.55473 * c + 6.98316) * c) : 0.0;
}

// Reflectance of a conductor of the index eta + i k for light polarised across (Rs) and in (Rp) the
// plane of incidence, seen from a dielectric of the index etaI > 0; eta, k >= 0. With both over
// etaI, t = eta^2 - k^2 - sin^2 and a + i b = sqrt(t + 2 i eta k):
//   Rs = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)
//   Rp = Rs ((a c - sin^2)^2 + b^2 c^2) / ((a c + sin^2)^2 + b^2 c^2)
// Fresnel's equations with a complex index (Born and Wolf, Principles of Optics, section 14.2).
// Sums of squares only: the smaller of a and b comes from a b = eta k, and
// a - c = ((eta^2 - 1) - k^2 + b^2) / (a + c), so neither a strong absorber nor an index close to
// that outside loses digits. Limits: all is reflected at grazing angles and for eta = 0, nothing
// where the indices are equal and k = 0.
void conductorReflectances(Incidence i, float etaI, float eta, float k, OUT(float) Rs,
                           OUT(float) Rp) {
    float n = eta / etaI;
    float k2 = k * k / (etaI * etaI);
    float ab = n * k / etaI;
    float s2 = sin2Incidence(i);
    float t = refractedG2(i, etaI, eta) - k2;
    float big = 0.5 * (sqrt(t * t + 4.0 * ab * ab) + abs(t));
    float less = ab * ab / max(big, 1e-30);
    float a2 = t > 0.0 ? big : less;
    float b2 = t > 0.0 ? less : big;
    float a = sqrt(a2);
    Rs = 1.0;
    Rp = 1.0;
    if (etaI == eta && k == 0.0) {
        Rs = 0.0;
        Rp = 0.0;
    } else if (i.c > 0.0 && a > 0.0) {
        float difference = ((eta - etaI) * (eta + etaI) / (etaI * etaI) - k2 + b2) / (a + i.c);
        Rs = min((sqr(difference) + b2) / (sqr(a + i.c) + b2), 1.0); // rounding may pass 1
        float bc2 = b2 * i.c * i.c;
        Rp = Rs * (sqr(a * i.c - s2) + bc2) / (sqr(a * i.c + s2) + bc2);
    }
}

// Fresnel's reflectance of a conductor for ordinary light, the mean of Rs and Rp, from the cosine c
// of the angle of incidence and the index eta + i k relative to that on the light's side.
float fresnelConductor(float c, float eta, float k) {
    float Rs;
    float Rp;
    conductorReflectances(incidenceOf(c), 1.0, eta, k, Rs, Rp);
    return 0.5 * (Rs + Rp);
}

// The same for eta^2 + k^2 >> 1, where a = eta and b = k at every angle; with m = eta^2 + k^2:
//   Rs = (m - 2 eta c + c^2) / (m + 2 eta c + c^2)
//   Rp = (m c^2 - 2 eta c + 1) / (m c^2 + 2 eta c + 1)
// Born and Wolf, section 14.2, equation 17. For bare metals within 0.0071, and exact facing the
// surface. Numerators are written as sums of squares, (eta - c)^2 + k^2 and (eta c - 1)^2 + k^2
// c^2.
float fresnelConductorHighIndex(float c, float eta, float k) {
    float k2 = k * k;
    float Rs = (sqr(eta - c) + k2) / max(sqr(eta + c) + k2, 1e-30);
    float Rp = (sqr(eta * c - 1.0) + k2 * c * c) / (sqr(eta * c + 1.0) + k2 * c * c);
    return 0.5 * (Rs + Rp);
}

// Schlick's reflectance of a conductor, F0 + (1 - F0)(1 - c)^5 with F0 that of the index eta + i k:
// ((eta - 1)^2 + k^2 + 4 eta (1 - c)^5) / ((eta + 1)^2 + k^2). Lazanyi and Szirmay-Kalos, Fresnel
// Term Approximations for Metals, WSCG 2005, equation 4.
float schlickConductor(Incidence i, float eta, float k) {
    float k2 = k * k;
    return (sqr(eta - 1.0) + k2 + 4.0 * eta * pow5(i.versine)) / (sqr(eta + 1.0) + k2);
}

// The index of the dielectric that reflects F0 facing the surface, (1 + sqrt F0) / (1 - sqrt F0),
// written (1 + sqrt F0)^2 / (1 - F0). F0 0 .. 1; at 1, where it has no finite value, 4e30.
float indexFromF0(float F0) {
    return sqr(1.0 + sqrt(F0)) / max(1.0 - F0, 1e-30);
}

// The dielectric whose reflectance facing the surface is F0, eta = (1 + sqrt F0) / (1 - sqrt F0),
// for ordinary light. Blinn, SIGGRAPH 1977, with the index from F0 as in Cook and Torrance, ACM TOG
// 1(1), 1982. Multiplied by q = 1 - sqrt F0, so that F0 = 1, an infinite index, is not
// special: with G = q g = sqrt(4 sqrt F0 + q^2 c^2)
//   Rs = (4 sqrt F0 / (G + q c)^2)^2        Rp = Rs ((c G - q sin^2) / (c G + q sin^2))^2
// F0 0 .. 1. Limits: everything at grazing angles, nothing for F0 = 0.
float blinnF0Reflectance(Incidence i, float F0) {
    if (!(F0 > 0.0)) {
        return 0.0;
    }
    float r = sqrt(F0);
    float q = (1.0 - F0) / (1.0 + r);
    float G = sqrt(4.0 * r + sqr(q * i.c));
    float s2 = q * sin2Incidence(i);
    float Rs = min(sqr(4.0 * r / sqr(G + q * i.c)), 1.0);
    float w = i.c > 0.0 ? (i.c * G - s2) / (i.c * G + s2) : 1.0;
    return 0.5 * Rs * (1.0 + w * w);
}

// Strauss's Fresnel weight, 0 at x = 0 and 1 at x = 1:
//   F(x) = (1 / (x - kf)^2 - 1 / kf^2) / (1 / (1 - kf)^2 - 1 / kf^2)
// Strauss, A Realistic Lighting Model for Computer Animators, IEEE CG&A 10(6), 1990. x is an angle
// in right angles and y = 1 - x; kf > 1. Multiplied out, so that no reciprocals are subtracted.
float straussWeight(float x, float y, float kf) {
    return x * (2.0 * kf - x) * sqr((kf - 1.0) / (y + (kf - 1.0))) / (2.0 * kf - 1.0);
}

// Strauss's shadowing, 1 at x = 0 and 0 at x = 1, y = 1 - x, ks > 1:
//   G(x) = (1 / (1 - ks)^2 - 1 / (x - ks)^2) / (1 / (1 - ks)^2 - 1 / ks^2)
// The same paper; multiplied out. With kf in the place of ks it is 1 - F(x).
float straussShadowing(float y, float ks) {
    return ks * ks * y * (y + 2.0 * (ks - 1.0)) / ((2.0 * ks - 1.0) * sqr(y + (ks - 1.0)));
}
