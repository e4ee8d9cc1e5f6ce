// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// Fresnel's reflectance of a metal for one channel, the mean of both polarisations.
float namedMetalReflectance(Incidence i, float etaI, float eta, float k) {
    float Rs;
    float Rp;
    conductorReflectances(i, etaI, eta, k, Rs, Rp);
    return 0.5 * (Rs + Rp);
}

float metalFresnelChannel(Incidence i, MetalFresnel p, float eta, float k) {
    if (p.reflectance == METAL_FRESNEL_REFLECTANCE_HIGH_INDEX) {
        return fresnelConductorHighIndex(i.c, eta / p.indexOutside, k / p.indexOutside);
    }
    if (p.reflectance == METAL_FRESNEL_REFLECTANCE_SCHLICK) {
        return schlickConductor(i, eta / p.indexOutside, k / p.indexOutside);
    }
    return namedMetalReflectance(i, p.indexOutside, eta, k);
}

// A table's entries: the exact reflectance by the cosine.
vec3 metalFresnelCosinesEntry(vec2 u, MetalFresnel p) {
    Incidence i = incidenceOf(u.x);
    return vec3(namedMetalReflectance(i, p.indexOutside, p.eta.x, p.k.x),
                namedMetalReflectance(i, p.indexOutside, p.eta.y, p.k.y),
                namedMetalReflectance(i, p.indexOutside, p.eta.z, p.k.z));
}

// Per channel, by the constants at its wavelength.
vec3 metalFresnel(Incidence i, MetalFresnel p) {
    if (p.reflectance == METAL_FRESNEL_REFLECTANCE_TABLE) {
        return metalFresnelCosines(vec2(i.c, 0.0), p);
    }
    return vec3(metalFresnelChannel(i, p, p.eta.x, p.k.x),
                metalFresnelChannel(i, p, p.eta.y, p.k.y),
                metalFresnelChannel(i, p, p.eta.z, p.k.z));
}

vec3 metalFresnelTint(MetalFresnel p) {
    return p.color;
}
