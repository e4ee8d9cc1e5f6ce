// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/half_difference.glsl"

const float grainTurns = 60.0; // azimuths of the half vector that a table has
const float grainShare = 32.0 / 33.0; // of the rows of one, those that hold something

// Reads f from the part of a file's table that belongs to the half vector at an azimuth, which
// stands over the others along the difference angle.
vec3 measuredAtTurn(vec3 place, float turn, MeasuredGrain p) {
    place.y = (turn + place.y * grainShare) / grainTurns;
    return measuredGrainFile(place, p);
}

// The mean of both azimuths beside that of h. At h = n, which has none, the angles count from the
// tangent.
vec3 measuredGrain(Directions d, MeasuredGrain p) {
    Directions g = alongGrain(d, p.tangentAngle);
    vec3 place = halfDifferencePlace(g);
    float azimuth = g.tH == 0.0 && g.bH == 0.0 ? 0.0 : atan(g.bH, g.tH);
    float turn = azimuth / (2.0 * PI) * grainTurns;
    float low = floor(turn);
    float share = turn - low;
    low = low < 0.0 ? low + grainTurns : low;
    low = min(low, grainTurns - 1.0);
    float high = low + 1.0 < grainTurns ? low + 1.0 : 0.0;
    vec3 f = mix(measuredAtTurn(place, low, p), measuredAtTurn(place, high, p), share);
    return PI * g.nl * f;
}
