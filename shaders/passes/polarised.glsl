// SPDX-License-Identifier: MIT-0
// Light whose field swings along a line more than across it.
#include "lib/fresnel.glsl"
#include "lib/polarisation.glsl"

// How much of the light that is looked at swings across the plane of incidence: half of ordinary
// light.
float fieldAcross = 0.5;

// The reflectance of that light over that of ordinary light.
float polarisedShare(float Rs, float Rp) {
    float sum = Rs + Rp;
    return sum > 1e-30 ? 2.0 * mix(Rp, Rs, fieldAcross) / sum : 1.0;
}

// The same of a clear surface and of a metal.
float polarisedDielectric(Incidence i, float etaI, float etaT) {
    float Rs;
    float Rp;
    dielectricReflectances(i, etaI, etaT, Rs, Rp);
    return polarisedShare(Rs, Rp);
}

float polarisedConductor(Incidence i, float etaI, float eta, float k) {
    float Rs;
    float Rp;
    conductorReflectances(i, etaI, eta, k, Rs, Rp);
    return polarisedShare(Rs, Rp);
}

// The same of a surface that reflects F0 facing the light and R from where it comes: as the clear
// surface of that F0 does, also where F0 is 0, and no more than all of either light.
float polarisedF0(Incidence i, float F0, float R) {
    float index = min(indexFromF0(clamp(F0, 0.0, 1.0)), 1e4);
    return polarisedShare(1.0, clamp(2.0 * R - 1.0, dielectricRatio(i, index), 1.0));
}

// How much of light from l swings across the plane of l and v, the plane of incidence of what is
// mirrored from the one to the other. Its field swings along `field.xyz`, of which the part along l
// is none, by the share `field.w`; the rest is ordinary light. Where both are the same line there
// is no plane, and no difference.
float acrossOf(vec3 l, vec3 v, vec4 field) {
    vec3 across = cross(l, v);
    vec3 swings = field.xyz - dot(field.xyz, l) * l;
    float size = dot(across, across) * dot(swings, swings);
    float along = dot(across, swings);
    return size > 1e-14 ? mix(0.5, min(along * along / size, 1.0), field.w) : 0.5;
}

// The reflectance of that light by that of ordinary light and that of light that swings across the
// plane of incidence.
vec3 polarisedOf(vec3 ordinary, vec3 across) {
    return max(mix(2.0 * ordinary - across, across, fieldAcross), vec3(0.0));
}
