// SPDX-License-Identifier: MIT-0
// An environment as lobes of von Mises' and Fisher's form, and matte surfaces, see it.
#include "passes/octahedral_levels.glsl"

uniform sampler2D environmentBlurred; // level 0 is sharp, level 1 seen by a lobe of LOG2_KAPPA - 2, ...

const float LAST_LEVEL = float(OCTAHEDRAL_LEVELS - 1);

vec3 environmentTexel(vec2 at) {
    return texture(environmentBlurred, at * vec2(2.0 / 3.0, 1.0)).rgb;
}

// Of a lobe around `d`, in the environment's own directions; `kappa` is its log2.
vec3 environmentSeenBy(vec3 d, float kappa) {
    vec2 place = octahedralPlace(d);
    float level = clamp(0.5 * (float(LOG2_KAPPA) - kappa), 0.0, LAST_LEVEL);
    float share = exp2(-floor(level));
    float coarserShare = max(0.5 * share, exp2(-LAST_LEVEL));
    return mix(environmentTexel(octahedralLevel(place, octahedralOrigin(share), share)),
        environmentTexel(octahedralLevel(place, octahedralOrigin(coarserShare), coarserShare)),
        fract(level));
}

// What a white matte surface shows whose normal is `n`, in the environment's own directions.
vec3 environmentOnMatte(vec3 n) {
    return environmentTexel(octahedralLevel(octahedralPlace(n), MATTE_ORIGIN, MATTE_SHARE));
}
