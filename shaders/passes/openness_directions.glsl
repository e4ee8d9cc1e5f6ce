// SPDX-License-Identifier: MIT-0
// How much of an environment's light comes past the object itself.
#include "passes/openness.glsl"

#define OPEN_SHARE opened.share
#define OPEN_MEAN(n) ((n) + (opened.direction - opened.normal))
#define OPEN_TOWARDS(d, edge) openTowards(d, edge)

// The edge of the cone stands for edges of any form, so it is never sharp: half its width, as a
// cosine. That of a lobe, by the log2 of its kappa, is about its own width in radians.
#define OPEN_EDGE 0.25
#define OPEN_LOBE_EDGE(kappa) clamp(1.1875 - 0.1875 * (kappa), OPEN_EDGE, 1.0)

// What the cone leaves of light from around the unit direction `d`, over what the horizon leaves of
// it: 1 where nothing is hidden, and no more than the cone has of the light's own solid angle.
float openTowards(vec3 d, float edge) {
    float whole = clamp(dot(d, opened.normal) + edge, 0.0, 2.0 * edge);
    float seen = clamp(dot(d, opened.direction) - opened.cone + edge, 0.0, 2.0 * edge);
    float size = edge * edge;
    float fits = min(2.0 * (1.0 - opened.cone), size);
    return min(fits * (seen + 1e-4 * opened.share) / (size * (whole + 1e-4)), 1.0);
}
