// SPDX-License-Identifier: MIT-0
// The environment as one light, in the place of each direction of a round.
#include "passes/environment_mean.glsl"

void noteOneLight() {
    Illumination light = meanLight();
    for (int i = 0; i < 4; ++i) {
        noteValue(FIRST_SAMPLE + 2 * i, vec4(light.l, 0.0));
        noteValue(FIRST_SAMPLE + 2 * i + 1, vec4(light.radiance, 0.0));
    }
}
