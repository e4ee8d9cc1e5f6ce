// SPDX-License-Identifier: MIT-0
// The colour between vertices, in linear light, and its alpha.

centroid in vec4 vertexColor;

// The luminance of Rec. 709.
float vertexGrey() {
    return dot(vertexColor.rgb, vec3(0.2126, 0.7152, 0.0722));
}
