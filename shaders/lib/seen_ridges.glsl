// SPDX-License-Identifier: MIT-0
// What a viewer sees of a strip of the ridges of lib/ridges.glsl that is narrower than a period.
// The viewer looks from the side of +b. A line of sight is called by where it passes the height of
// the ridges' tops: z radii beyond the line that grazes a ridge on its far side, 0 .. d.
#include "lib/elementary.glsl"
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

// ridgeLobe() by 5 Gauss-Legendre points instead of 16, on either side of where the lobe is largest to
// 2.8 deviations: up to 0.003 of the integral of the lobe alone over all angles off, on an arc that is
// a deviation long a ten-thousandth.
float quickRidgeLobe(vec2 arc, vec3 h, float e, vec2 view, vec2 light) {
    float largest = max(arc.x, min(h.x, arc.y));
    float off = abs(largest - h.x);
    float reach2 = 7.84 / (e + 1.0);
    float reach = reach2 / (sqrt(off * off + reach2) + off);
    float from = max(arc.x, largest - reach);
    float to = min(arc.y, largest + reach);
    if (!(to > from)) {
        return 0.0;
    }
    float nodes[3];
    float weights[3];
    nodes[0] = 0.0;
    nodes[1] = 0.5384693101056831;
    nodes[2] = 0.906179845938664;
    weights[0] = 0.28444444444444444; // the middle is summed up twice
    weights[1] = 0.4786286704993665;
    weights[2] = 0.2369268850561891;
    float sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int side = -1; side < 2; side += 2) {
            float psi = 0.5 * (from + to + float(side) * nodes[i] * (to - from));
            float s = sin(psi - h.x);
            float c = cos(psi - h.x);
            float lobe = c > 0.0 ? powSC(h.y + h.z * s * s, h.z * c * c, e) : 0.0;
            float facing = sin(view.x + view.y * psi) * sin(light.x + light.y * psi);
            sum += weights[i] * lobe * max(facing, 0.0);
        }
    }
    return 0.5 * (to - from) * sum;
}
