// SPDX-License-Identifier: MIT-0
// The numerical check: every number of a pixel is looked at as it was computed, before anything
// cuts or clamps it. Only programs of that view contain this file.
#include "passes/texture_place.glsl"

// What a pixel shows when nothing is wrong is 0; of several defects the last one is shown.
const float ABOVE_ONE = 1.0;
const float NEGATIVE = 2.0;
const float INFINITE = 3.0;
const float NO_NUMBER = 4.0;

// The share by which the estimate of the albedo may be off.
const float ALBEDO_DOUBT = 0.02;

// The terms of a pixel that a probe reads, in windows of this many from `firstTerm` on: first
// those below, then one for each light in the order of the program.
const int WINDOW = 7;
const int TERM_NORMAL = 0;   // w: n.v
const int TERM_ALBEDO = 1;   // w: 1 where there is one
const int TERM_AMBIENT = 2;
const int TERM_EMISSION = 3;
const int TERM_BLENDED = 4;  // w: the reflectance that blends (green)
const int TERM_FOGGED = 5;   // w: the share of the surface's colour that is left
const int TERM_STORED = 6;   // w: opacity
const int TERM_LIGHT = 7;    // w: n.l

// What is stored in place of the numbers to check (InspectedView).
const int SHOWN_NUMBERS = 0;
const int SHOWN_ENERGY = 1;
const int SHOWN_NORMALS = 2;
const int SHOWN_TANGENTS = 3;
const int SHOWN_DIFFUSE = 4;
const int SHOWN_HIGHLIGHT = 5;
const int SHOWN_COORDINATES = 6;
const int SHOWN_FRESNEL = 7;
const int SHOWN_LIGHT = 8;
const int SHOWN_OCCLUSION = 9;
const int SHOWN_GLOW = 10;
const int SHOWN_OPACITY = 11;

uniform int shown;
uniform int shownLight; // its place in the order of the program; -1 where it is not there
uniform int firstTerm;
uniform float objectNumber; // what the pixel shows, from 1 on

layout(location = 1) out vec4 storedTerms[WINDOW];

float defect = 0.0;
vec4 terms[WINDOW];
int lightTerm = TERM_LIGHT;
vec3 modelled = vec3(0.0); // what the model returned last
float share = 1.0;         // what was blended with last
vec3 modelledTerm = vec3(0.0); // the shown term of what the model returned last
vec4 litTerm = vec4(0.0);      // its sum over the lights; w: 1 where there is one
vec4 fresnelTerm = vec4(0.0);  // at the viewer's angle; w: 1 where there is one
vec4 opennessTerm = vec4(0.0); // w: 1 where it is known
vec3 glow = vec3(0.0);

// How many squares of the checker lie between 0 and 1 of a texture coordinate.
const float CHECKS = 8.0;

// From the bits: compilers may take a comparison with a number for always true.
float defectOf(float x) {
    uint magnitude = floatBitsToUint(x) & 0x7fffffffu;
    if (magnitude >= 0x7f800000u) {
        return magnitude > 0x7f800000u ? NO_NUMBER : INFINITE;
    }
    return x < 0.0 ? NEGATIVE : 0.0;
}

void clearTerms() {
    for (int i = 0; i < WINDOW; ++i) {
        terms[i] = vec4(0.0);
    }
}

void lookAt(vec3 value) {
    defect = max(defect, max(max(defectOf(value.r), defectOf(value.g)), defectOf(value.b)));
}

void noteTerm(int index, vec3 value, float detail) {
    glow += index == TERM_EMISSION ? value : vec3(0.0);
    int place = index - firstTerm;
    if (place >= 0 && place < WINDOW) {
        terms[place] += vec4(value, detail);
    }
}

vec3 lookedShare(vec3 x) {
    lookAt(x);
    share = x.g;
    return x;
}

float lookedShare(float x) {
    lookAt(vec3(x));
    share = x;
    return x;
}

float shownGrey(vec3 color) {
    return storable(dot(color, vec3(0.2126, 0.7152, 0.0722)));
}

// A value that is stored, and a half where it is not known.
vec4 shownTerm(vec4 term) {
    return vec4(storable(term.r), storable(term.g), storable(term.b), 0.5 + 0.5 * term.w);
}

// Red and green: a place in an image; blue: 1 on every other square of the checker. A mesh without
// coordinates has the same ones everywhere.
vec4 shownCoordinates(vec2 place) {
    vec2 square = floor(fract(place) * CHECKS);
    float isKnown = fwidth(place.x) + fwidth(place.y) > 0.0 ? 1.0 : 0.0;
    return shownTerm(vec4(fract(place.x), fract(place.y), mod(square.x + square.y, 2.0), isKnown));
}

// The shown thing; alpha is a half where it is not known of this surface.
vec4 shownOf(Surface s, vec4 albedo, float opacity) {
    if (shown == SHOWN_ENERGY) {
        return vec4(albedo.rgb, 0.5 + 0.5 * albedo.a);
    }
    if (shown == SHOWN_NORMALS) {
        return vec4(s.n, 1.0);
    }
    if (shown == SHOWN_TANGENTS) {
        return vec4(s.t, 1.0);
    }
    if (shown == SHOWN_COORDINATES) {
        return shownCoordinates(surfaceUv);
    }
    if (shown == SHOWN_LIGHT) { // black where none of it arrives
        return shownTerm(vec4(litTerm.rgb, 1.0));
    }
    if (shown == SHOWN_GLOW) { // black where there is none
        return shownTerm(vec4(glow, 1.0));
    }
    if (shown == SHOWN_OPACITY) {
        return shownTerm(vec4(vec3(opacity), 1.0));
    }
    if (shown == SHOWN_OCCLUSION) {
        return shownTerm(opennessTerm);
    }
    return shownTerm(shown == SHOWN_FRESNEL ? fresnelTerm : litTerm);
}

// Red: the picture's luminance; green: the defect; blue: the object. Nothing of it is blended or
// averaged.
void storeInspected(Surface s, vec3 color, vec4 albedo, float alpha) {
    lookAt(color);
    if (defect == 0.0 && max(max(albedo.r, albedo.g), albedo.b) > 1.0 + ALBEDO_DOUBT) {
        defect = ABOVE_ONE;
    }
    noteTerm(TERM_NORMAL, s.n, dot(s.n, s.v));
    noteTerm(TERM_ALBEDO, albedo.rgb, albedo.a);
    noteTerm(TERM_STORED, color, alpha);
    storedColor = shown == SHOWN_NUMBERS ? vec4(shownGrey(color), defect, objectNumber, 1.0)
                                         : shownOf(s, albedo, alpha);
    for (int i = 0; i < WINDOW; ++i) {
        storedTerms[i] = terms[i];
    }
}
