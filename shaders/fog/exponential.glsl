// SPDX-License-Identifier: MIT-0

// exp(-density x). Bouguer 1729.
float exponentialFog(float x, ExponentialFog p) {
    return exp(-p.density * x);
}

vec3 exponentialFogColor(ExponentialFog p) {
    return p.color;
}
