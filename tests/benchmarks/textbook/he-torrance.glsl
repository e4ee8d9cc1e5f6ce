// SPDX-License-Identifier: GPL-3.0-or-later
// Abramowitz and Stegun 1964, 7.1.26.
float textbookErfc(float x) {
    float t = 1.0 / (1.0 + 0.3275911 * x);
    return t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027
        + t * 1.061405429)))) * exp(-x * x);
}

float textbookShadowing(float a) {
    float Lambda = 0.5 * (exp(-a * a) / (a * sqrt(PI)) - textbookErfc(a));
    return (1.0 - 0.5 * textbookErfc(a)) / (Lambda + 1.0);
}

// The metal's reflectance facing it, moved to the angle; see Schlick 1994.
vec3 textbookMetal(HeTorrance p, float c) {
    vec3 eta = p.fresnel.eta;
    vec3 k2 = p.fresnel.k * p.fresnel.k;
    vec3 tmp = (eta * eta + k2) * c * c;
    vec3 Rp = (tmp - 2.0 * eta * c + vec3(1.0)) / (tmp + 2.0 * eta * c + vec3(1.0));
    vec3 sum = eta * eta + k2;
    vec3 Rs = (sum - 2.0 * eta * c + vec3(c * c)) / (sum + 2.0 * eta * c + vec3(c * c));
    return 0.5 * (Rp + Rs);
}

// He, Torrance, Sillion and Greenberg 1991 with Newton steps for z0 and 40 terms as printed.
vec3 heTorrance(Directions d, HeTorrance p) {
    float nl = dot(N, L);
    float nv = dot(N, V);
    vec3 H = L + V;
    vec3 h = normalize(H);
    float al = 0.5 * p.tau / (p.sigma0 * tan(acos(nl)));
    float av = 0.5 * p.tau / (p.sigma0 * tan(acos(nv)));
    float K = 0.25 * (tan(acos(nl)) * textbookErfc(al) + tan(acos(nv)) * textbookErfc(av));
    float z = 0.0;
    for (int i = 0; i < 8; ++i) {
        float e = K * exp(-0.5 * z * z);
        z -= (sqrt(0.5 * PI) * z - e) / (sqrt(0.5 * PI) + e * z);
    }
    float sigma = p.sigma0 / sqrt(1.0 + z * z);
    float S = textbookShadowing(al) * textbookShadowing(av);
    float G = pow(dot(H, H) / dot(N, H), 2.0);
    vec3 F = textbookMetal(p, dot(V, h));
    vec3 value = p.diffuseColor * nl;
    for (int channel = 0; channel < 3; ++channel) {
        float k = 2.0 * PI / p.wavelengths[channel];
        float g = pow(k * sigma * (nl + nv), 2.0);
        vec3 across = k * (H - N * dot(N, H));
        float xy2 = dot(across, across) * p.tau * p.tau;
        float power = 1.0;
        float factorial = 1.0;
        float sum = 0.0;
        for (int m = 1; m <= 40; ++m) {
            float n = float(m);
            power *= g;
            factorial *= n;
            sum += power * exp(-g) / (factorial * n) * exp(-xy2 / (4.0 * n));
        }
        float D = pow(PI * p.tau / (2.0 * p.wavelengths[channel]), 2.0) * sum;
        value[channel] += F[channel] * G * S * D / nv;
    }
    return value;
}
