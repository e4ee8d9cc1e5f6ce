// SPDX-License-Identifier: MIT-0
// The picture of an environment that has one.

uniform sampler2D environmentImage;

vec3 environmentPicture(vec3 d) {
    return textureLod(environmentImage, environmentPlace(d), 0.0).rgb;
}
