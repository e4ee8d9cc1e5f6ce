// SPDX-License-Identifier: MIT-0

int softShadowTaps(SoftShadow p) {
    int coarse = 16;
    int normal = 32;
    int fine = 96;
    if (p.samples == SOFT_SHADOW_SAMPLES_FINE) {
        return fine;
    }
    return p.samples == SOFT_SHADOW_SAMPLES_COARSE ? coarse : normal;
}

// R. Fernando, Percentage-closer soft shadows, SIGGRAPH 2005 sketches: the edge is as wide as the
// light's image through a small hole where the blockers are.
float softShadow(ShadowPoint s, SoftShadow p) {
    float slope = shadowSlope(s, 0.5 * p.angle, 0.5 * p.size);
    int taps = softShadowTaps(p);
    float searched = max(shadowEdge(s, slope, shadowReach(s)), s.texel);
    int fewer = taps / 2;
    vec2 found = shadowFound(s, searched, fewer);
    if (found.y <= 0.0 || found.y >= 1.0) {
        return found.y <= 0.0 ? 1.0 : 0.0;
    }
    float radius = max(shadowEdge(s, slope, found.x), 1.5 * s.texel);
    return shadowMean(s, min(radius, shadowWidest(s, found.x)), taps);
}
