// SPDX-License-Identifier: MIT-0
// The image of thresholds that a pass has. It repeats.

uniform sampler2D thresholdImage; // each number from 0 to 1 is as frequent as any other

// The threshold at a place in images, 1/2 without one.
float pictureThreshold(vec2 place) {
    return textureLod(thresholdImage, place - floor(place), 0.0).r;
}

// How high the image is for its width.
float pictureThresholdHeight() {
    vec2 size = vec2(textureSize(thresholdImage, 0));
    return size.y / size.x;
}
