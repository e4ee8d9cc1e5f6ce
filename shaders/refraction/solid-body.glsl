// SPDX-License-Identifier: MIT-0
#include "lib/interface.glsl"

vec3 solidBodyIndices(SolidBodyRefraction p) {
    return dispersedIndices(p.index, p.dispersion);
}

// Snell's law for one channel, into the body and out of it.
vec3 solidBodyRefraction(Interface c, SolidBodyRefraction p) {
    return crossedDirection(c, solidBodyIndices(p));
}

// Fresnel's reflectance of each surface that a ray meets.
float solidBodyRefractionMirrored(Interface c, SolidBodyRefraction p) {
    return crossedReflectance(c, solidBodyIndices(p));
}

vec3 solidBodyRefractionLeft(float way, SolidBodyRefraction p) {
    return p.tint * leftAfter(way, p.absorptionColor, p.absorptionDistance);
}
