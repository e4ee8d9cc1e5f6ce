// SPDX-License-Identifier: MIT-0
// A picture in another size; where it becomes larger, the texture's filter makes it smooth.

uniform sampler2D picture;
uniform vec2 newSize; // in pixels

layout(location = 0) out vec4 stretched;

void main() {
    stretched = texture(picture, gl_FragCoord.xy / newSize);
}
