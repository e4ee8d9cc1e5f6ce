// SPDX-License-Identifier: MIT-0
// Where light goes that enters a transparent body, and the index that decides it.
#include "lib/elementary.glsl"
#include "lib/incidence.glsl"
#include "lib/math.glsl"

// g^2 = eta^2 - sin^2 = eta^2 cos^2 theta_t with eta = etaT / etaI; not positive beyond the
// critical angle. Snell's law, etaI sin theta_i = etaT sin theta_t. A small difference near the
// critical angle: of eta^2 - 1 and -c^2, or of eta^2 and sin^2, whichever are the smaller terms.
// etaI > 0.
float refractedG2(Incidence i, float etaI, float etaT) {
    float s2 = sin2Incidence(i);
    float s = etaI * sqrt(s2);
    float fromSine = (etaT - s) * (etaT + s) / (etaI * etaI);
    float fromCosine = (etaT - etaI) * (etaT + etaI) / (etaI * etaI) + i.c * i.c;
    return s2 < 0.5 ? fromSine : fromCosine;
}

// The cosine of the angle of refraction, theta_t, from that of incidence, c 0 .. 1, and eta, the
// index beyond the surface over that on the light's side, eta > 0; 0 from the critical angle on,
// where nothing passes.
float refractCos(float c, float eta) {
    float g2 = refractedG2(incidenceOf(c), 1.0, eta);
    return min(sqrt(max(g2, 0.0)) / eta, 1.0);
}

// The unit direction into the body of light that comes from the unit direction l, which points away
// from the surface like the unit normal n: (c / eta - cos theta_t) n - l / eta. The zero vector
// beyond the critical angle. (Heckbert, in Glassner, An Introduction to Ray Tracing, 1989, has the
// form with the ray's own direction -l.)
vec3 refractedDirection(vec3 l, vec3 n, float eta) {
    Incidence i = incidenceBetween(l, n);
    float g2 = refractedG2(i, 1.0, eta);
    if (g2 <= 0.0) {
        return vec3(0.0);
    }
    return ((i.c - sqrt(g2)) * n - l) / eta;
}

// An angle in radians, 0 .. pi / 2, from its squared sine and cosine.
float angleFrom(float s2, float c2) {
    float x;
    float y;
    angXY(sqrt(c2), s2, x, y);
    return 0.5 * PI * x;
}

// The angle of incidence in radians from which on all is reflected, sin theta = eta with eta the
// index beyond over that on the light's side, > 0; pi / 2, which no light reaches, where eta >= 1.
float criticalAngle(float eta) {
    float s = min(eta, 1.0);
    return angleFrom(s * s, (1.0 - s) * (1.0 + s));
}

// The angle of incidence in radians at which light polarised in the plane of incidence is not
// reflected, tan theta = eta (Brewster 1815); eta > 0 as above.
float brewsterAngle(float eta) {
    float scale = 1.0 / (1.0 + eta * eta);
    return angleFrom(eta * eta * scale, scale);
}

// Cauchy's dispersion, n = A + B / lambda^2 + C / lambda^4, per channel; wavelengths in
// micrometres, > 0, B in um^2, C in um^4 (Cauchy 1836). Good for clear materials in visible light.
vec3 cauchyIndex(vec3 wavelengths, float A, float B, float C) {
    vec3 w = vec3(1.0) / (wavelengths * wavelengths);
    return vec3(A) + w * (vec3(B) + w * C);
}

// One term of Sellmeier's equation, B lambda^2 / (lambda^2 - C), at most 1e6 B: nearer than a
// millionth of lambda^2 to its pole it no longer rises.
vec3 sellmeierTerm(vec3 wavelengths2, float B, float C) {
    vec3 apart = wavelengths2 - vec3(C);
    vec3 side = 2.0 * step(vec3(0.0), apart) - vec3(1.0);
    return B * wavelengths2 / (side * max(abs(apart), 1e-6 * wavelengths2));
}

// Sellmeier's dispersion, n^2 = 1 + sum B lambda^2 / (lambda^2 - C), per channel (Sellmeier 1871);
// wavelengths in micrometres, C in um^2: the squares of the wavelengths at which the material
// absorbs. Glass makers publish B and C of three terms; a term that is not there has B = 0.
vec3 sellmeierIndex(vec3 wavelengths, vec3 B, vec3 C) {
    vec3 w2 = wavelengths * wavelengths;
    vec3 n2 = vec3(1.0) + sellmeierTerm(w2, B.x, C.x) + sellmeierTerm(w2, B.y, C.y)
        + sellmeierTerm(w2, B.z, C.z);
    return sqrt(max(n2, vec3(0.0)));
}

// The index at a temperature from that at another, to first order: n + dn/dT (T - T0), temperatures
// in degrees Celsius and dn/dT per kelvin: about -4.5e-4 for organic liquids, -1e-4 for water and
// acrylic, a few 1e-6 for optical glass.
float indexAtTemperature(float index, float slope, float temperature, float measuredAt) {
    return index + slope * (temperature - measuredAt);
}
