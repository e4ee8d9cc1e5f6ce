// SPDX-License-Identifier: MIT-0

// exp(-(density x)^2).
float exponentialSquaredFog(float x, ExponentialSquaredFog p) {
    float opticalDepth = p.density * x;
    return exp(-opticalDepth * opticalDepth);
}

vec3 exponentialSquaredFogColor(ExponentialSquaredFog p) {
    return p.color;
}
