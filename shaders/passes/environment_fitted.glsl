// SPDX-License-Identifier: MIT-0
// The light of a whole environment on a surface whose reflectance has been fitted (lobe_fit.glsl): a
// matte part, which sees the environment's irradiance, and two lobes, each of which sees the
// environment as much out of focus as it is wide.
#include "lib/directions.glsl"

uniform sampler2DArray lobeTable; // of lobe_table.glsl: viewers (x) and azimuths, without an end (y)

vec3 fittedLight(Surface s) {
    float nv = clamp(dot(s.n, s.v), 0.0, 1.0);
    vec3 along = safeNormalize(s.v - nv * s.n, s.t);
    vec2 place = vec2((0.5 + sqrt(nv) * float((VIEWERS - 1) * TABLE_STEPS)) /
                          float((VIEWERS - 1) * TABLE_STEPS + 1),
        0.5);
    if (AZIMUTHS > 1) {
        place.y = atan(dot(along, s.b), dot(along, s.t)) / (2.0 * PI) +
                  0.5 / float(AZIMUTHS * TABLE_STEPS);
    }
    vec3 r = 2.0 * nv * s.n - s.v;
    vec4 shifts = texture(lobeTable, vec3(place, 3.0));
    vec3 narrowMean = r + shifts.x * along + shifts.y * s.n;
    vec3 wideMean = r + shifts.z * along + shifts.w * s.n;
    vec4 part = texture(lobeTable, vec3(place, 0.0));
    vec3 matteMean = s.n + part.a * along;
    if (AZIMUTHS > 1) {
        vec3 across = cross(s.n, along);
        vec4 sideways = texture(lobeTable, vec3(place, 4.0));
        narrowMean += sideways.x * across;
        wideMean += sideways.y * across;
        matteMean += sideways.z * across;
    }
    // One after another, so that few numbers are kept at a time.
    vec3 sum = OPEN_SHARE * part.rgb * environmentOnMatte(environmentInside(OPEN_MEAN(matteMean)));
    part = texture(lobeTable, vec3(place, 1.0));
    sum += OPEN_TOWARDS(narrowMean, OPEN_LOBE_EDGE(part.a)) * part.rgb *
           environmentSeenBy(environmentInside(narrowMean), part.a);
    part = texture(lobeTable, vec3(place, 2.0));
    return sum + OPEN_TOWARDS(wideMean, OPEN_LOBE_EDGE(part.a)) * part.rgb *
                     environmentSeenBy(environmentInside(wideMean), part.a);
}
