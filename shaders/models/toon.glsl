// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// 0 below -w/2 and 1 above w/2, smooth between. An edge is never narrower than 0.001: a harder one
// is a jump, on which a rounding of n.l would decide between two colours.
float toonStep(float x, float softness) {
    float t = clamp(x / max(softness, 1e-3) + 0.5, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// n.l - edge; near the normal as (1 - edge) - (1 - n.l), which keeps its digits.
float toonLead(Directions d, float edge) {
    return d.nl > 0.5 ? (1.0 - edge) - d.sin2l / (1.0 + d.nl) : d.nl - edge;
}

// 1 inside the spot around the mirror direction, by the ratio of the versines of its angle and of
// `size`, in radians. No spot at size 0.
float toonSpot(Directions d, float size, float softness) {
    float radius = versineOf(size);
    if (!(radius > 1e-12) || !(d.nl > 0.0)) {
        return 0.0;
    }
    return toonStep(1.0 - min(d.versineRv / radius, 1e6), softness);
}

// Two or three flat tones by n.l, per fragment. A. Lake et al., Stylized Rendering Techniques for
// Scalable Real-Time 3D Animation, NPAR 2000, section 3, with soft edges and a spot.
vec3 toon(Directions d, Toon p) {
    vec3 tone = mix(p.shadowColor, p.diffuseColor, toonStep(toonLead(d, p.threshold), p.softness));
    if (p.tones == TOON_TONES_THREE) {
        float brightAt = max(p.brightThreshold, p.threshold);
        tone = mix(tone, p.brightColor, toonStep(toonLead(d, brightAt), p.softness));
    }
    return tone + p.specularColor * (p.gloss * toonSpot(d, p.spotSize, p.softness));
}
