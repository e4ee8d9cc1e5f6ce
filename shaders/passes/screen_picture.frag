// SPDX-License-Identifier: MIT-0
// A part of a picture, in another size; where it becomes larger, the texture's filter makes it
// smooth.

uniform sampler2D picture;
uniform vec4 part; // of the picture, from 0 to 1: at a pixel times `xy` plus `zw`

layout(location = 0) out vec4 shown;

void main() {
    shown = texture(picture, gl_FragCoord.xy * part.xy + part.zw);
}
