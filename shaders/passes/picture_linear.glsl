// SPDX-License-Identifier: MIT-0
// Of a pass that works with linear light; IEC 61966-2-1, x in 0 .. 1.

float linearPart(float x) {
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

float encodedPart(float x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

vec3 linearColor(vec3 color) {
    return vec3(linearPart(color.r), linearPart(color.g), linearPart(color.b));
}

vec3 pictureColor(vec2 pixel) {
    return linearColor(encodedColor(pixel));
}

// The mean around a place, of about so many pixels' width; of what the eye sees.
vec3 pictureMean(vec2 pixel, float width) {
    return linearColor(encodedMean(pixel, width));
}

vec4 shownColor(vec3 color) {
    return vec4(encodedPart(shownPart(color.r)), encodedPart(shownPart(color.g)),
                encodedPart(shownPart(color.b)), 1.0);
}
