// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/fresnel.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"
#include "lib/seen_ridges.glsl"

// The part of a period that a pixel sees.
struct RidgeWindow {
    float from;  // periods
    float width; // 0 .. 1 of them; at 1 the mean over a period
};

// A pixel sees 1.25 times its width, so that ridges fade before they are as narrow as pixels. Where
// texture coordinates do not change there are none, and where a float no longer tells where in a
// period it is the window is as wide as that.
RidgeWindow ridgeWindow(AcrossRidges v, SeenRidges p) {
    RidgeWindow whole;
    whole.from = 0.0;
    whole.width = 1.0;
    if (!(p.ridgeWidth > 0.0)) {
        return whole;
    }
    // Across the grain, in periods.
    vec2 across = vec2(-sin(p.tangentAngle), cos(p.tangentAngle));
    float place = dot(across, p.coordinates) / p.ridgeWidth;
    float right = dot(across, p.coordinatesRight) / p.ridgeWidth;
    float up = dot(across, p.coordinatesUp) / p.ridgeWidth;
    float width = 1.25 * (abs(right) + abs(up));
    float unsure = abs(place) / 16384.0;
    if (!(width > 0.0) || !(width < 1.0) || !(unsure < 1.0)) {
        return whole;
    }
    RidgeWindow window;
    window.width = max(max(width, unsure), 1.0 / 32.0);
    // To the nearest whole number: a place just below one keeps its digits.
    float off = place - floor(place + 0.5);
    float middle = v.side * off + v.cosine / ((1.0 + v.sine) * p.spacing);
    window.from = middle - floor(middle) - 0.5 * window.width;
    return window;
}

// The light of a strip, times its width: of a white matte surface, and of the highlight.
vec2 stripLight(Directions g, SeenRidges p, AcrossRidges l, AcrossRidges v, vec3 h, vec2 strip) {
    SeenStrip seen = seenStrip(l, v, strip.x, strip.y, p.spacing, p.height);
    // Angles from the middle of the arc.
    AcrossRidges lit = l;
    lit.horizon = l.horizon + l.side * seen.middle;
    AcrossRidges looked = v;
    looked.horizon = v.horizon + seen.middle;
    vec2 arc = vec2(-0.5 * seen.arc, 0.5 * seen.arc);
    float share = 1.0 / max(v.cosine, 1e-20);
    float matte = l.across * share * ridgeFacing(lit, looked, arc) + seen.floorWidth * g.nl;
    bool isEven = p.normalisation == SEEN_RIDGES_NORMALISATION_NORMALISED;
    vec2 light = isEven ? vec2(lit.horizon, l.side) : vec2(0.5 * PI, 0.0);
    vec2 view = vec2(looked.horizon, 1.0);
    vec3 turned = vec3(h.x - seen.middle, h.y, h.z);
    float ridges = 0.0;
    if (p.points == SEEN_RIDGES_POINTS_EXACT) {
        ridges = ridgeLobe(arc, turned, p.shininess, view, light);
    } else {
        ridges = quickRidgeLobe(arc, turned, p.shininess, view, light);
    }
    float flatPart = seen.floorWidth * powSC(g.sin2h, g.cos2h, p.shininess);
    float lobes = share * ridges * (isEven ? l.across : 1.0) + flatPart * (isEven ? g.nl : 1.0);
    return vec2(matte, lobes);
}

// The mean of what a pixel sees: of the part of a period that it covers, and from a whole period on
// of that, which is Poulin and Fournier's average. Nothing changes over from one to the other.
vec3 seenRidges(Directions d, SeenRidges p) {
    Directions g = alongGrain(d, p.tangentAngle);
    AcrossRidges l = acrossRidges(g.nl, g.lb);
    AcrossRidges v = acrossRidges(g.nv, g.vb);
    RidgeWindow window = ridgeWindow(v, p);
    // Mirrored, so that the viewer is on the side of +b.
    float hb = v.side * g.bH;
    l.side = l.side * v.side;
    v.side = 1.0;
    float plane2 = g.nH * g.nH + hb * hb;
    float inPlane = max(sqrt(plane2), 1e-20);
    float turned = angleOf(abs(hb) / inPlane, g.nH / inPlane);
    vec3 h = vec3(hb < 0.0 ? -turned : turned, sqr(g.tH), plane2);
    vec2 seen = vec2(0.0);
    for (int period = -1; period < 2; ++period) {
        float from = window.from + float(period);
        float cut = max(-from, 0.0);
        float width = window.width - cut - max(from + window.width - 1.0, 0.0);
        if (width > 0.0) {
            vec2 strip = vec2((from + cut) * p.spacing, width * p.spacing);
            seen = seen + stripLight(g, p, l, v, h, strip);
        }
    }
    seen = seen / (window.width * p.spacing);
    bool isEven = p.normalisation == SEEN_RIDGES_NORMALISATION_NORMALISED;
    float lobe = seen.y * (isEven ? blinnNormalisation(p.shininess) : 1.0);
    vec3 highlight = p.specularColor * slotFresnel(halfIncidence(d), p.fresnel) * lobe;
    return p.diffuseColor * seen.x
        + glossed(highlight, p.gloss, p.glossMode == SEEN_RIDGES_GLOSS_MODE_LIMIT,
            isEven ? g.nl : 1.0);
}
