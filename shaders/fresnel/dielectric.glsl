// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// Fresnel's reflectance, the mean of both polarisations or one of them.
vec3 dielectricFresnel(Incidence i, DielectricFresnel p) {
    if (p.polarisation == DIELECTRIC_FRESNEL_POLARISATION_UNPOLARISED) {
        if (p.reflectanceClear == DIELECTRIC_FRESNEL_REFLECTANCE_CLEAR_SCHLICK) {
            return vec3(schlickDielectric(i, p.indexOutside, p.indexInside));
        }
        if (p.reflectanceClear == DIELECTRIC_FRESNEL_REFLECTANCE_CLEAR_EXPONENTIAL) {
            return vec3(exponentialDielectric(i, p.indexOutside, p.indexInside));
        }
    }
    float Rs;
    float Rp;
    dielectricReflectances(i, p.indexOutside, p.indexInside, Rs, Rp);
    if (p.polarisation == DIELECTRIC_FRESNEL_POLARISATION_S) {
        return vec3(Rs);
    }
    if (p.polarisation == DIELECTRIC_FRESNEL_POLARISATION_P) {
        return vec3(Rp);
    }
    return vec3(0.5 * (Rs + Rp));
}

vec3 dielectricFresnelTint(DielectricFresnel p) {
    return p.color;
}
