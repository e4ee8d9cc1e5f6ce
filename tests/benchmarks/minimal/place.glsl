// SPDX-License-Identifier: GPL-3.0-or-later
// Where an image lies on the surface.
centroid in vec2 surfaceUv;
uniform vec3 imageAcross;
uniform vec3 imageUp;
uniform sampler2D image;

vec4 texel() {
    vec3 place = vec3(surfaceUv, 1.0);
    return texture(image, vec2(dot(imageAcross, place), dot(imageUp, place)));
}
