// SPDX-License-Identifier: MIT-0
// Out of focus, from the small picture of the environment: a disc of directions, each from a level
// of the picture that is half as coarse as the disc is wide, so that few rounds look smooth.
#include "lib/directions.glsl"

uniform sampler2D environmentSmall;
uniform float backgroundBlur; // half the width of the disc, in radians

vec3 backgroundRadiance(vec3 d, uint round, Environment p) {
    vec2 u = environmentPoint(round, environmentSeed(8u));
    float angle = backgroundBlur * sqrt(u.x);
    float turn = 2.0 * PI * u.y;
    vec3 t = anyTangent(d);
    vec3 b = cross(d, t);
    vec3 towards = cos(angle) * d + sin(angle) * (cos(turn) * t + sin(turn) * b);
    float texels = backgroundBlur * environmentData[1].y / PI;
    float level = log2(max(0.5 * texels, 1.0));
    return textureLod(environmentSmall, environmentPlace(environmentInside(towards)), level).rgb;
}
