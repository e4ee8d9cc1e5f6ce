// SPDX-License-Identifier: MIT-0
// What a surface is shaded from, in whole floats. Where it is comes from passes/surface.glsl.

// So many values of a surface fit beside the rest; others are drawn again from `firstValue` on.
const int WINDOW = 5;

uniform int firstValue;
uniform float objectNumber; // what the pixel shows, from 1 on

layout(location = 1) out vec4 storedNormal; // w: opacity
layout(location = 2) out vec4 storedTangent;
layout(location = 3) out vec4 storedValues[WINDOW];

vec4 values[WINDOW];
int shares = 0; // noted so far

void clearValues() {
    for (int i = 0; i < WINDOW; ++i) {
        values[i] = vec4(0.0);
    }
}

void noteValue(int index, vec4 value) {
    int place = index - firstValue;
    if (place >= 0 && place < WINDOW) {
        values[place] += value;
    }
}

// What is left of the next light; four of them lie in one value.
void noteShare(float share) {
    int part = shares % 4;
    vec4 value = vec4(part == 0 ? share : 0.0, part == 1 ? share : 0.0, part == 2 ? share : 0.0,
                      part == 3 ? share : 0.0);
    noteValue(FIRST_SHARE + shares / 4, value);
    ++shares;
}

void storeBuffer(Surface s, float alpha) {
    storedColor = vec4(s.x, objectNumber);
    storedNormal = vec4(s.n, alpha);
    storedTangent = vec4(s.t, 0.0);
    for (int i = 0; i < WINDOW; ++i) {
        storedValues[i] = values[i];
    }
}
