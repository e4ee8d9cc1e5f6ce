// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/half_difference.glsl"

const float grainTurns = 60.0; // azimuths of the half vector that a table has

// Reads f from the part of a file's table that belongs to the half vector at an azimuth. Parts lie
// along all axes, 5 x 4 x 3, since a float tells places along one with all of them less well. Of the
// 22 x 33 x 65 bins of a part the outer two of the first axis are those of its other end, and the
// last of the others are empty.
vec3 measuredAtTurn(vec3 place, float turn, MeasuredGrain p) {
    float row = floor((turn + 0.5) / 5.0);
    float layer = floor((row + 0.5) / 4.0);
    vec3 part = vec3(turn - 5.0 * row, row - 4.0 * layer, layer);
    vec3 inPart = (place * vec3(20.0, 32.0, 64.0) + vec3(1.0, 0.0, 0.0)) / vec3(22.0, 33.0, 65.0);
    return measuredGrainFile((part + inPart) / vec3(5.0, 4.0, 3.0), p);
}

// The mean of both azimuths beside that of h. At h = n, which has none, the angles count from the
// tangent.
vec3 measuredGrain(Directions d, MeasuredGrain p) {
    Directions g = alongGrain(d, p.tangentAngle);
    vec3 place = halfDifferencePlace(g);
    float turn = angleInPlane(g.tH, g.bH) / (2.0 * PI) * grainTurns;
    float low = floor(turn);
    float share = turn - low;
    low = low < 0.0 ? low + grainTurns : low;
    low = min(low, grainTurns - 1.0);
    float high = low + 1.0 < grainTurns ? low + 1.0 : 0.0;
    vec3 f = mix(measuredAtTurn(place, low, p), measuredAtTurn(place, high, p), share);
    return PI * g.nl * f;
}
