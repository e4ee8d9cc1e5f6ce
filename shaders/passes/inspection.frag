// SPDX-License-Identifier: MIT-0
// The numerical check on the screen: the picture in muted grey, and each defect in a colour and a
// pattern of its own, so that nobody has to tell them by the colour alone.

uniform sampler2D linearImage;
uniform float exposureFactor;

layout(location = 0) out vec4 displayed;

// A light and a dark shade of one colour.
vec3 shades(vec3 light, vec3 dark, bool inPattern) {
    return inPattern ? light : dark;
}

vec3 patternOf(int defect, vec2 place) {
    if (defect == 4) { // not a number: checks
        bool check = (int(place.x / 4.0) + int(place.y / 4.0)) % 2 == 0;
        return shades(vec3(1.0, 0.2, 0.85), vec3(0.25, 0.0, 0.2), check);
    }
    if (defect == 3) { // infinite: rising stripes
        return shades(vec3(1.0, 0.85, 0.1), vec3(0.35, 0.2, 0.0),
            fract((place.x - place.y) / 8.0) < 0.5);
    }
    if (defect == 2) { // negative: level stripes
        return shades(vec3(0.25, 0.6, 1.0), vec3(0.0, 0.05, 0.35), fract(place.y / 6.0) < 0.5);
    }
    vec2 cell = fract(place / 6.0) - 0.5; // above one: dots
    return shades(vec3(1.0, 0.5, 0.2), vec3(0.3, 0.13, 0.1), dot(cell, cell) < 0.1);
}

// Brightness of the picture between a dark and a middle grey.
float mutedGrey(float light) {
    float x = max(light * exposureFactor, 0.0);
    return 0.12 + 0.42 * sqrt(x / (1.0 + x));
}

void main() {
    vec4 stored = texelFetch(linearImage, ivec2(gl_FragCoord.xy), 0);
    int defect = int(stored.g + 0.5);
    vec3 grey = vec3(mutedGrey(min(stored.r, 65504.0)));
    displayed = vec4(defect == 0 ? grey : patternOf(defect, gl_FragCoord.xy), 1.0);
}
