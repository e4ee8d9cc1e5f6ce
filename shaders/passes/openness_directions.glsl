// SPDX-License-Identifier: MIT-0
// How much of an environment's light comes past the object itself.
#include "passes/openness.glsl"

#define OPEN_SHARE opened.share
#define OPEN_MEAN(n) ((n) + (opened.direction - opened.normal))
#define OPEN_TOWARDS(d, width) openTowards(d, width)

// The edge of the cone stands for edges of any form, so it is never sharp.
const float OPEN_EDGE = 0.25;

// What the cone leaves of light from around the unit direction `d`, over what the horizon leaves of
// it: 1 where nothing is hidden, and no more than the cone has of the light's own solid angle.
// `width`: of the light, in radians.
float openTowards(vec3 d, float width) {
    float edge = clamp(width, OPEN_EDGE, 1.0);
    float whole = smoothstep(-edge, edge, dot(d, opened.normal));
    float seen = smoothstep(-edge, edge, dot(d, opened.direction) - opened.cone);
    float fits = min((1.0 - opened.cone) / (0.5 * edge * edge), 1.0);
    return fits * (whole > 1e-3 ? min(seen / whole, 1.0) : opened.share);
}
