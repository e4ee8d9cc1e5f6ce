// SPDX-License-Identifier: MIT-0
// A whole environment as one light: from where most of it comes, as bright as it makes a white matte
// surface that faces there.
#include "lib/illumination.glsl"

Illumination meanLight() {
    const int C = ENVIRONMENT_HARMONICS;
    const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);
    // The harmonics of the first degree are the mean direction of what arrives.
    vec3 mean = vec3(dot(environmentData[C + 3].rgb, LUMINANCE),
        dot(environmentData[C + 1].rgb, LUMINANCE), dot(environmentData[C + 2].rgb, LUMINANCE));
    vec3 inside = safeNormalize(mean, vec3(0.0, 1.0, 0.0));
    Illumination light;
    light.l = environmentOutside(inside);
    light.radiance = environmentIrradiance(inside);
    return light;
}
