// SPDX-License-Identifier: MIT-0
// An environment as lobes of von Mises' and Fisher's form see it.

uniform samplerCube environmentBlurred; // level 0 by a lobe of FINEST, each further one 4 times wider

const float FINEST = 12.0; // log2 of kappa
const float SHARP = 14.0;  // from here on the environment itself is looked at

// Of a lobe around `d`, unit, in the environment's own directions; `kappa` is its log2.
vec3 environmentSeenBy(vec3 d, float kappa, Environment e) {
    vec3 seen = kappa < SHARP
        ? textureLod(environmentBlurred, d, max(0.5 * (FINEST - kappa), 0.0)).rgb : vec3(0.0);
    if (kappa > FINEST) {
        float share = min((kappa - FINEST) / (SHARP - FINEST), 1.0);
        seen = mix(seen, environmentRadiance(d, e), share);
    }
    return seen;
}
