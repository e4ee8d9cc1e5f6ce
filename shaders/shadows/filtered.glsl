// SPDX-License-Identifier: MIT-0

int filteredShadowTaps(FilteredShadow p) {
    int coarse = 12;
    int normal = 24;
    int fine = 64;
    if (p.samples == FILTERED_SHADOW_SAMPLES_FINE) {
        return fine;
    }
    return p.samples == FILTERED_SHADOW_SAMPLES_COARSE ? coarse : normal;
}

// The mean of comparisons (not of depths) over a disk: W. T. Reeves, D. H. Salesin and R. L. Cook,
// Rendering antialiased shadows with depth maps, SIGGRAPH 1987. Far from an edge a few places tell.
// What rises less than 45 degrees above the surface's plane is taken for the surface itself.
float filteredShadow(ShadowPoint s, FilteredShadow p) {
    int probes = 6;
    float widest = s.view.size / 16.0;
    s.rise = shadowedRise(s, 1.0);
    float radius = max(0.5 * min(p.width, widest), 1.5 * s.texel);
    vec2 found = shadowFound(s, radius, probes);
    if (found.y <= 0.0 || found.y >= 1.0) {
        return found.y <= 0.0 ? 1.0 : 0.0;
    }
    return shadowMean(s, min(radius, shadowWidest(s, found.x)), filteredShadowTaps(p));
}
