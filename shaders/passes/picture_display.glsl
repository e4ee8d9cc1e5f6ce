// SPDX-License-Identifier: MIT-0
// Of a pass that works with colours as a display takes them.

vec3 pictureColor(vec2 pixel) {
    return encodedColor(pixel);
}

// The mean around a place, of about so many pixels' width.
vec3 pictureMean(vec2 pixel, float width) {
    return encodedMean(pixel, width);
}

vec4 shownColor(vec3 color) {
    return vec4(shownPart(color.r), shownPart(color.g), shownPart(color.b), 1.0);
}
