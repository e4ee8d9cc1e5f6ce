// SPDX-License-Identifier: MIT-0
#include "lib/picture_point.glsl"

// How far x is from the nearest whole number, as a share of the most it can be: even from 0 to 1.
float screenWave(float x) {
    return 2.0 * abs(x - floor(x + 0.5));
}

// The share of a square with side 1 that is at most r away from its middle.
float screenDisk(float r) {
    float pi = 3.14159265;
    if (r <= 0.5) {
        return pi * r * r;
    }
    float beside = sqrt(max(r * r - 0.25, 0.0));
    return min(pi * r * r - 4.0 * (r * r * acos(min(0.5 / r, 1.0)) - 0.5 * beside), 1.0);
}

// The threshold of an image and how much it changes within a pixel, a place being in pixels.
vec2 screenImage(vec2 place, float width) {
    float across = 1.0 / width;
    float up = across / pictureThresholdHeight();
    vec2 at = vec2(place.x * across, place.y * up);
    float here = pictureThreshold(at);
    float beside = abs(pictureThreshold(at + vec2(across, 0.0)) - here);
    float above = abs(pictureThreshold(at + vec2(0.0, up)) - here);
    return vec2(here, 0.5 * max(beside, above));
}

// The threshold of a place in units of the spacing: the share of the plane with less is the
// threshold itself.
float screenThreshold(vec2 place, ScreenPass p) {
    if (p.mark == SCREEN_PASS_MARK_LINES) {
        return screenWave(place.y);
    }
    if (p.mark == SCREEN_PASS_MARK_CROSSES) {
        float bare = 1.0 - min(screenWave(place.x), screenWave(place.y));
        return 1.0 - bare * bare;
    }
    if (p.mark == SCREEN_PASS_MARK_SPIRAL) {
        float away = sqrt(place.x * place.x + place.y * place.y);
        float turn = away > 1e-4 ? atan(place.y, place.x) / 6.28318531 : 0.0;
        return screenWave(away - turn);
    }
    vec2 apart = place - floor(place + vec2(0.5));
    return screenDisk(sqrt(dot(apart, apart)));
}

// How much of a pixel is inked by a tone, 0 .. 1. Edges are a pixel wide, less where the mark is
// narrower, so that the share of the plane stays the tone. `pixels` are those of the picture in one
// of a picture that is 512 pixels high.
float screenInk(vec2 place, float dark, float spacing, float pixels, ScreenPass p) {
    // Each threshold is somebody's: where the paper is bare the smallest would leave dust on it.
    if (!(dark > 0.0 && dark < 1.0)) {
        return dark > 0.5 ? 1.0 : 0.0;
    }
    if (p.mark == SCREEN_PASS_MARK_IMAGE) {
        vec2 threshold = screenImage(place * spacing, max(p.thresholdWidth * pixels, 1.0));
        float edge = max(min(threshold.y, min(dark, 1.0 - dark)), 1e-4);
        return clamp(0.5 + (dark - threshold.x) / (2.0 * edge), 0.0, 1.0);
    }
    float soft = max(min(1.0 / spacing, min(dark, 1.0 - dark)), 1e-4);
    return clamp(0.5 + (dark - screenThreshold(place, p)) / (2.0 * soft), 0.0, 1.0);
}

vec2 screenPlace(vec2 pixel, float angle, float spacing) {
    float c = cos(angle);
    float s = sin(angle);
    return vec2(c * pixel.x + s * pixel.y, c * pixel.y - s * pixel.x) * (1.0 / spacing);
}

// What differs from white or black by half a step of 8 bits at white is white or black.
float screenDark(float light, ScreenPass p) {
    float rounding = 0.0045;
    return 1.0 - pow(clamp((light - rounding) / (1.0 - 2.0 * rounding), 0.0, 1.0), p.strength);
}

vec3 screenPass(PicturePoint at, ScreenPass p) {
    float spacing = max(p.spacing * at.scale, 2.0);
    vec3 color = pictureColor(at.pixel);
    vec3 n = pictureSurface(at.pixel).normal;
    vec2 place = at.pixel - 0.5 * at.size + (p.swirl * at.scale) * vec2(n.x, n.y);
    if (p.colors == SCREEN_PASS_COLORS_INK) {
        float light = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
        return mix(p.paper, p.ink,
                   screenInk(screenPlace(place, p.angle, spacing), screenDark(light, p), spacing,
                             at.scale, p));
    }
    // Black takes the grey that all plates have in common, and half of it stays to them.
    float most = max(max(color.r, color.g), color.b);
    float grey = screenDark(most, p);
    vec3 left = color * (1.0 / max(most, 1e-4));
    float degrees15 = 0.26179939;
    float c = screenInk(screenPlace(place, p.angle - 2.0 * degrees15, spacing),
                        screenDark(left.r, p), spacing, at.scale, p);
    float m = screenInk(screenPlace(place, p.angle + 2.0 * degrees15, spacing),
                        screenDark(left.g, p), spacing, at.scale, p);
    float y = screenInk(screenPlace(place, p.angle - 3.0 * degrees15, spacing),
                        screenDark(left.b, p), spacing, at.scale, p);
    float k = screenInk(screenPlace(place, p.angle, spacing), grey, spacing, at.scale, p);
    vec3 shown = p.paper;
    shown *= mix(vec3(1.0), vec3(0.01, 0.34, 0.75), c);
    shown *= mix(vec3(1.0), vec3(0.8, 0.01, 0.25), m);
    shown *= mix(vec3(1.0), vec3(0.95, 0.75, 0.01), y);
    return mix(shown, p.ink * shown, k);
}
