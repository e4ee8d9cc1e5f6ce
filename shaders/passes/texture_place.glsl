// SPDX-License-Identifier: MIT-0
// Images on the surface. Two vec4s of objectData belong to each: the rows that take (u, v, 1) to
// the place in the image; the first's w is how much of it counts, the second's the threshold of a
// cut-out.
#include "passes/blocks.glsl"

centroid in vec2 surfaceUv; // not beyond the edge, where the other side of the image begins

vec2 imagePlace(int rows) {
    vec4 across = objectData[rows];
    vec4 up = objectData[rows + 1];
    return vec2(dot(across.xy, surfaceUv) + across.z, dot(up.xy, surfaceUv) + up.z);
}

// The luminance of Rec. 709.
float imageGrey(vec3 color) {
    return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

// A value that an image has changed, in the range that forms and files keep it in.
vec3 imaged(vec3 value, vec3 made, int rows, float lowest, float highest) {
    return clamp(mix(value, made, objectData[rows].w), lowest, highest);
}

float imaged(float value, float made, int rows, float lowest, float highest) {
    return clamp(mix(value, made, objectData[rows].w), lowest, highest);
}
