// SPDX-License-Identifier: MIT-0
// A picture that is laid over another one: its rows begin at the top, and its colours are
// multiplied by their opacity already.

uniform sampler2D picture;
uniform vec2 newSize; // in pixels

layout(location = 0) out vec4 laid;

void main() {
    laid = texture(picture, vec2(gl_FragCoord.x, newSize.y - gl_FragCoord.y) / newSize);
}
