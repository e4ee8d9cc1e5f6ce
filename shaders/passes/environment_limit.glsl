// SPDX-License-Identifier: MIT-0
// Where light above a limit is sent by lights of the scene in the environment's place: what is
// brighter keeps its colour. `x` is finite. At 0, which a slider may pass, there is no limit.

vec3 environmentCut(vec3 x, float most) {
    float brightness = dot(x, vec3(0.2126, 0.7152, 0.0722));
    return most > 0.0 && brightness > most ? x * (most / brightness) : x;
}
