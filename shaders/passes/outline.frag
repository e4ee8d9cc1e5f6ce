// SPDX-License-Identifier: MIT-0
// A line has its own colour, whatever light there is.
#include "passes/blocks.glsl"
#include "passes/storable.glsl"

in vec3 linePoint;

layout(location = 0) out vec4 storedColor;

void storeLine(vec3 color) {
    storedColor = vec4(storable(color.r), storable(color.g), storable(color.b), 1.0);
}
