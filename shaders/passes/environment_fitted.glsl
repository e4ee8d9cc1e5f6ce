// SPDX-License-Identifier: MIT-0
// The light of a whole environment on a surface whose reflectance has been fitted (lobe_fit.glsl): a
// matte part, lit by the nine harmonics of the environment, and two lobes, each of which sees the
// environment as much out of focus as it is wide.
#include "lib/directions.glsl"

uniform sampler2DArray lobeTable;

// Of one viewer or between those next to it.
vec4 tableEntry(int layer, ivec2 entries, float between) {
    vec4 a = texelFetch(lobeTable, ivec3(entries.x % TABLE_WIDTH, entries.x / TABLE_WIDTH, layer), 0);
    vec4 b = texelFetch(lobeTable, ivec3(entries.y % TABLE_WIDTH, entries.y / TABLE_WIDTH, layer), 0);
    return mix(a, b, between);
}

vec4 tableAt(int layer, vec2 place) {
    float x = clamp(place.x, 0.0, 1.0) * float(VIEWERS - 1);
    int first = int(x);
    ivec2 entries = ivec2(first, min(first + 1, VIEWERS - 1));
    if (AZIMUTHS == 1) {
        return tableEntry(layer, entries, x - float(first));
    }
    float y = place.y * float(AZIMUTHS);
    int row = int(floor(y));
    int below = VIEWERS * (row % AZIMUTHS);
    int above = VIEWERS * ((row + 1) % AZIMUTHS);
    return mix(tableEntry(layer, entries + below, x - float(first)),
        tableEntry(layer, entries + above, x - float(first)), y - floor(y));
}

vec3 fittedLight(Surface s, Environment e) {
    float nv = clamp(dot(s.n, s.v), 0.0, 1.0);
    vec3 along = safeNormalize(s.v - nv * s.n, s.t);
    vec3 across = cross(s.n, along);
    vec2 place = vec2(sqrt(nv), 0.0);
    if (AZIMUTHS > 1) {
        place.y = fract(atan(dot(along, s.b), dot(along, s.t)) / (2.0 * PI) + 1.0);
    }
    vec3 r = 2.0 * nv * s.n - s.v;
    vec3 sum = tableAt(0, place).rgb * environmentIrradiance(environmentInside(s.n));
    for (int i = 1; i < 5; i += 2) {
        vec4 shape = tableAt(i + 1, place);
        vec3 d = r + shape.x * along + shape.y * across + shape.z * s.n;
        sum += tableAt(i, place).rgb *
               environmentSeenBy(normalize(environmentInside(d)), shape.w, e);
    }
    return sum;
}
