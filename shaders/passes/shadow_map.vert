// SPDX-License-Identifier: MIT-0
// A depth map: from object space to the map of one light.

layout(location = 0) in vec3 position;

uniform mat4 objectToMap;

void main() {
    gl_Position = objectToMap * vec4(position, 1.0);
}
