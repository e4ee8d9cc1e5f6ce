// SPDX-License-Identifier: MIT-0

// Ld = L (1 + L / W^2) / (1 + L) (Reinhard et al. 2002, eq. 4), as a factor of the colour.
vec3 reinhardTone(vec3 light, ReinhardTone p) {
    float luminance = 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
    return light * ((1.0 + luminance / (p.white * p.white)) / (1.0 + luminance));
}
