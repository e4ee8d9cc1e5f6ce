// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/gloss.glsl"

// 0 below an edge at x = 0 that is as wide as `softness`, 1 above it.
float toonRise(float x, float softness) {
    float t = clamp(0.5 + x / max(softness, 1e-3), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// The share of `above` where x is above an edge as wide as `softness`, and of `below` under it;
// the smaller share by itself, so that it is no difference. An edge is never narrower than 0.001: a
// harder one is a jump, on which a rounding of n.l would decide between two colours.
vec3 toonEdge(float x, float softness, vec3 below, vec3 above) {
    float place = x / max(softness, 1e-3);
    float u = max(0.5 - abs(place), 0.0);
    float minShare = u * u * (3.0 - 2.0 * u);
    float maxShare = 1.0 - minShare;
    return (place > 0.0 ? minShare : maxShare) * below + (place > 0.0 ? maxShare : minShare) * above;
}

// n.l - edge; near the normal as (1 - edge) - (1 - n.l), which keeps its digits.
float toonLead(Directions d, float edge) {
    return d.nl > 0.5 ? (1.0 - edge) - d.versineL : d.nl - edge;
}

// Inside the spot around the mirror direction its colour, by the ratio of the versines of the angle
// and of `size`, in radians. No spot at size 0.
vec3 toonSpot(Directions d, Toon p) {
    float radius = versineOf(p.spotSize);
    float inside = 1.0 - d.versineRv / max(radius, 1e-12);
    float share = radius > 1e-12 && d.nl > 0.0 ? toonRise(inside, p.softness) : 0.0;
    bool limits = p.glossMode == TOON_GLOSS_MODE_LIMIT;
    return glossedLobe(p.specularColor, share, p.gloss, limits, share);
}

// Two or three flat tones by n.l, per fragment. A. Lake et al., Stylized Rendering Techniques for
// Scalable Real-Time 3D Animation, NPAR 2000, with soft edges, a spot, and a ramp of tones.
vec3 toon(Directions d, Toon p) {
    vec3 spot = toonSpot(d, p); // needs most directions, and then they are over
    if (p.tones == TOON_TONES_RAMP) {
        return toonToneRamp(d.nl, p) + spot;
    }
    vec3 tone = toonEdge(toonLead(d, p.threshold), p.softness, p.shadowColor, p.diffuseColor);
    if (p.tones == TOON_TONES_THREE) {
        float brightAt = max(p.brightThreshold, p.threshold);
        tone = toonEdge(toonLead(d, brightAt), p.softness, tone, p.brightColor);
    }
    return tone + spot;
}
