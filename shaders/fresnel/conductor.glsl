// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// At the cosine c, for one channel.
float metalReflectance(float c, float etaI, float eta, float k) {
    float Rs;
    float Rp;
    conductorReflectances(incidenceOf(c), etaI, eta, k, Rs, Rp);
    return 0.5 * (Rs + Rp);
}

// A table's entries: the exact reflectance by the cosine.
vec3 conductorFresnelMetalEntry(vec2 u, ConductorFresnel p) {
    return vec3(metalReflectance(u.x, p.indexOutside, p.eta.x, p.k.x),
                metalReflectance(u.x, p.indexOutside, p.eta.y, p.k.y),
                metalReflectance(u.x, p.indexOutside, p.eta.z, p.k.z));
}

float conductorChannel(Incidence i, ConductorFresnel p, float eta, float k) {
    if (p.reflectance == CONDUCTOR_FRESNEL_REFLECTANCE_HIGH_INDEX) {
        return fresnelConductorHighIndex(i.c, eta / p.indexOutside, k / p.indexOutside);
    }
    if (p.reflectance == CONDUCTOR_FRESNEL_REFLECTANCE_SCHLICK) {
        return schlickConductor(i, eta / p.indexOutside, k / p.indexOutside);
    }
    float Rs;
    float Rp;
    conductorReflectances(i, p.indexOutside, eta, k, Rs, Rp);
    return 0.5 * (Rs + Rp);
}

// Fresnel's reflectance of a metal, the mean of both polarisations, per channel.
vec3 conductorFresnel(Incidence i, ConductorFresnel p) {
    if (p.reflectance == CONDUCTOR_FRESNEL_REFLECTANCE_TABLE) {
        return conductorFresnelMetal(vec2(i.c, 0.0), p);
    }
    return vec3(conductorChannel(i, p, p.eta.x, p.k.x), conductorChannel(i, p, p.eta.y, p.k.y),
                conductorChannel(i, p, p.eta.z, p.k.z));
}

vec3 conductorFresnelTint(ConductorFresnel p) {
    return p.color;
}
