// SPDX-License-Identifier: MIT-0
// What a model sends to each viewer of the table of lobes (rows) from each direction of light
// (columns), times the solid angle of that direction, over pi: the sum of a row is the albedo.
#include "passes/lobe_directions.glsl"
#include "passes/reflectance_limits.glsl"

layout(location = 0) out vec4 storedSample;

void storeSample(Model p) {
    ivec2 cell = ivec2(gl_FragCoord.xy);
    vec3 v = tableViewer(cell.y);
    vec4 light = tableLight(v, cell.x);
    float turn = 2.0 * PI * float(cell.y / VIEWERS) / float(AZIMUTHS);
    vec3 t = vec3(cos(turn), -sin(turn), 0.0);
    vec3 b = vec3(sin(turn), cos(turn), 0.0);
    Directions d = directions(vec3(0.0, 0.0, 1.0), t, b, light.xyz, v);
    vec3 value = IS_DARK(d) ? vec3(0.0) : shadeModel(d, p);
    storedSample = vec4(light.w / PI * reflectanceLimited(value), 1.0);
}
