// SPDX-License-Identifier: MIT-0
// What a white matte surface shows under the environment, by its normal, as an octahedral picture.
#include "passes/octahedral_levels.glsl"

layout(location = 0) out vec4 storedRadiance;

void main() {
    vec2 place = (gl_FragCoord.xy - 1.0) / (MATTE_SHARE * OCTAHEDRAL_WIDTH - 2.0);
    storedRadiance = vec4(environmentIrradiance(octahedralDirection(place)), 1.0);
}
