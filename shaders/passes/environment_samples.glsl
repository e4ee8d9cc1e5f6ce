// SPDX-License-Identifier: MIT-0
// One round of directions of the environment, and what arrives from each: the light of
// passes/environment_light.glsl before it is multiplied by the model. No lobe is looked for, so that
// the directions are those of any model.
#include "passes/environment_directions.glsl"

void noteSamples(Surface s, Environment e) {
    int first = int(environmentData[0].z);
    Lobe none;
    none.t = s.t;
    none.b = s.b;
    none.width = vec2(0.0);
    for (int rule = 0; rule < RULES; ++rule) {
        vec2 u = environmentPoint(uint(first), environmentSeed(uint(rule)));
        vec3 l = normalize(drawnDirection(s, none, rule, u));
        vec3 inside = environmentInside(l);
        float density = drawnDensity(s, none, directionsAt(s, l, s.v), l, inside);
        vec3 arriving = vec3(0.0);
        if (density > 0.0) {
            arriving = OPEN_TOWARDS(l, OPEN_EDGE) * environmentRadiance(inside, e) / (PI * density);
        }
        noteValue(FIRST_SAMPLE + 2 * rule, vec4(l, 0.0));
        noteValue(FIRST_SAMPLE + 2 * rule + 1, vec4(arriving, 0.0));
    }
}
