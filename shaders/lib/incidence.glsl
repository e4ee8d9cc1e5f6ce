// SPDX-License-Identifier: MIT-0
#include "lib/math.glsl"

// How steeply light meets a surface: what a Fresnel term is a function of.
struct Incidence {
    float c;       // cosine of the angle of incidence, 0 .. 1
    float versine; // 1 - c, known without cancellation
};

// The incidence of a cosine alone; below the horizon counts as grazing.
Incidence incidenceOf(float c) {
    Incidence i;
    i.c = clamp(c, 0.0, 1.0);
    i.versine = 1.0 - i.c;
    return i;
}

// The incidence of a cosine c >= 0 whose squared sine s2 is known: 1 - c = s2 / (1 + c).
Incidence incidenceAt(float c, float s2) {
    Incidence i;
    i.c = min(c, 1.0);
    i.versine = min(s2 / (1.0 + c), 1.0);
    return i;
}

// The incidence between unit vectors a and b: 1 - a.b = |a - b|^2 / 2, which keeps every digit of
// a small angle. More than 90 degrees counts as grazing.
Incidence incidenceBetween(vec3 a, vec3 b) {
    vec3 difference = a - b;
    Incidence i;
    i.versine = min(0.5 * dot(difference, difference), 1.0);
    i.c = clamp(dot(a, b), 0.0, 1.0);
    return i;
}

// sin^2 of the angle of incidence: 1 - c^2 = (1 - c)(1 + c).
float sin2Incidence(Incidence i) {
    return i.versine * (1.0 + i.c);
}
