// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// The index of each channel, 0.01 .. 100 whatever the constants are.
vec3 dispersiveFresnelIndices(DispersiveFresnel p) {
    vec3 wavelengths = 0.001 * p.wavelength;
    vec3 indices;
    if (p.formula == DISPERSIVE_FRESNEL_FORMULA_CAUCHY) {
        indices = cauchyIndex(wavelengths, p.cauchy.x, p.cauchy.y, p.cauchy.z);
    } else {
        vec3 n = sellmeierIndex(wavelengths, p.sellmeierB, p.sellmeierC);
        vec3 fourth = sellmeierTerm(wavelengths * wavelengths, p.sellmeierB4, p.sellmeierC4);
        indices = sqrt(max(n * n + fourth, vec3(0.0)));
    }
    for (int channel = 0; channel < 3; ++channel) {
        indices[channel] = indexAtTemperature(indices[channel], p.temperatureSlope, p.temperature,
                                              p.temperatureMeasured);
    }
    return clamp(indices, vec3(0.01), vec3(100.0));
}

float dispersiveReflectance(Incidence i, float etaI, float etaT) {
    float Rs;
    float Rp;
    dielectricReflectances(i, etaI, etaT, Rs, Rp);
    return 0.5 * (Rs + Rp);
}

// Fresnel's reflectance for ordinary light, per channel.
vec3 dispersiveFresnel(Incidence i, DispersiveFresnel p) {
    vec3 indices = dispersiveFresnelIndices(p);
    return vec3(dispersiveReflectance(i, p.indexOutside, indices.x),
                dispersiveReflectance(i, p.indexOutside, indices.y),
                dispersiveReflectance(i, p.indexOutside, indices.z));
}

vec3 dispersiveFresnelTint(DispersiveFresnel p) {
    return p.color;
}

float dispersiveAcross(Incidence i, float etaI, float etaT) {
    float Rs;
    float Rp;
    dielectricReflectances(i, etaI, etaT, Rs, Rp);
    return Rs;
}

// The same for light that swings across the plane of incidence.
vec3 dispersiveFresnelAcross(Incidence i, DispersiveFresnel p) {
    vec3 indices = dispersiveFresnelIndices(p);
    return vec3(dispersiveAcross(i, p.indexOutside, indices.x),
                dispersiveAcross(i, p.indexOutside, indices.y),
                dispersiveAcross(i, p.indexOutside, indices.z));
}
