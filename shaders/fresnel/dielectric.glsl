// SPDX-License-Identifier: MIT-0
#include "lib/fresnel.glsl"

// A table's entries: the reflectance by the cosine on the side of the smaller index, where neither
// total reflection nor its edge is.
vec3 dielectricFresnelClearEntry(vec2 u, DielectricFresnel p) {
    float less = min(p.indexOutside, p.indexInside);
    float more = max(p.indexOutside, p.indexInside);
    float Rs;
    float Rp;
    dielectricReflectances(incidenceOf(u.x), less, more, Rs, Rp);
    return vec3(0.5 * (Rs + Rp));
}

// Beyond the critical angle the cosine counts as 0, where all is reflected.
vec3 dielectricFresnelTabled(Incidence i, DielectricFresnel p) {
    float c = i.c;
    if (p.indexInside < p.indexOutside) {
        float g2 = refractedG2(i, p.indexOutside, p.indexInside);
        c = min(safeSqrt(g2) * p.indexOutside / p.indexInside, 1.0);
    }
    return dielectricFresnelClear(vec2(c, 0.0), p);
}

// Fresnel's reflectance, the mean of both polarisations or one of them.
vec3 dielectricFresnel(Incidence i, DielectricFresnel p) {
    if (p.polarisation == DIELECTRIC_FRESNEL_POLARISATION_UNPOLARISED) {
        if (p.reflectanceClear == DIELECTRIC_FRESNEL_REFLECTANCE_CLEAR_TABLE) {
            return dielectricFresnelTabled(i, p);
        }
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
