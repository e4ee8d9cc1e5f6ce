// SPDX-License-Identifier: MIT-0
// One frame of several whose mean is the picture; how much it counts is the blending's matter.

uniform sampler2D linearImage;

layout(location = 0) out vec4 counted;

void main() {
    counted = texelFetch(linearImage, ivec2(gl_FragCoord.xy), 0);
}
