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

// The mean share over `taps` places.
float filteredShadowMean(ShadowPoint s, float radius, int taps) {
    float lit = 0.0;
    for (int i = 0; i < taps; ++i) {
        lit += shadowLit(s, radius * shadowDisk(s, i, taps));
    }
    return lit / float(taps);
}

// The mean of comparisons (not of depths) over a disk: W. T. Reeves, D. H. Salesin and R. L. Cook,
// Rendering antialiased shadows with depth maps, SIGGRAPH 1987. Far from an edge a few places tell.
float filteredShadow(ShadowPoint s, FilteredShadow p) {
    int probes = 6;
    float radius = max(0.5 * p.width, 1.5 * s.texel);
    float probed = filteredShadowMean(s, radius, probes);
    if (probed <= 0.0 || probed >= 1.0) {
        return probed;
    }
    return filteredShadowMean(s, radius, filteredShadowTaps(p));
}
