// SPDX-License-Identifier: MIT-0
// What a viewer sees of a strip of the ridges of lib/ridges.glsl that is narrower than a period.
// The viewer looks from the side of +b. A line of sight is called by where it passes the height of
// the ridges' tops: z radii beyond the line that grazes a ridge on its far side, 0 .. d.
#include "lib/ridges.glsl"

// The part of a strip that is seen and lit.
struct SeenStrip {
    float middle;     // psi in the middle of its arc of a ridge
    float arc;        // how long that is
    float floorWidth; // how much of it is floor
};

// How much of from .. from + width lies in a range.
float partWithin(vec2 range, float from, float width) {
    return max(width - max(range.x - from, 0.0) - max(from + width - range.y, 0.0), 0.0);
}

// Where a line of sight meets a ridge, with A = eta_v + psi its angle from where it grazes it:
// z = (1 - cos A) / cos phi_v. An arc follows from the strip's width and not from two angles, so
// that a narrow one keeps its digits; where light or the floor cut it off, from where they do.
SeenStrip seenStrip(AcrossRidges l, AcrossRidges v, float from, float width, float spacing,
    float height) {
    float x = min(0.5 * from * v.cosine, 1.0);
    float part = min(0.5 * width * v.cosine, 1.0 - x);
    float y = x + part;
    float s = part / max(sqrt(y * (1.0 - x)) + sqrt(x * (1.0 - y)), 1e-20);
    s = min(s, 1.0);
    float reach = angleOf(s, sqrt((1.0 - s) * (1.0 + s)));
    SeenStrip seen;
    seen.middle = 2.0 * angleOf(sqrt(x), sqrt(1.0 - x)) + reach - v.horizon;
    vec2 arc = commonArc(ridgeArc(l, spacing, height), ridgeArc(v, spacing, height));
    float low = seen.middle - reach;
    float high = seen.middle + reach;
    seen.arc = 2.0 * reach;
    if (low < arc.x || high > arc.y) {
        low = max(low, arc.x);
        high = min(high, arc.y);
        seen.arc = max(high - low, 0.0);
        seen.middle = 0.5 * (low + high);
    }

    // A place on the floor is so far beyond its line of sight at the tops. Above the axes the floor
    // also shows before the ridge.
    float c = max(v.cosine, 1e-20);
    float slide = (1.0 - height) * v.sine / c + v.cosine / (1.0 + v.sine);
    vec2 strip = commonArc(floorStrip(l, spacing, height), floorStrip(v, spacing, height));
    strip = vec2(strip.x + slide, strip.y + slide);
    seen.floorWidth = partWithin(strip, from, width)
        + partWithin(vec2(strip.x - spacing, strip.y - spacing), from, width);
    return seen;
}
