// SPDX-License-Identifier: MIT-0
// Where a vertex is along the object's axes, for models that draw on the surface.
#include "passes/object_axes.glsl"

out vec3 drawnPlace; // metres; a scale of the object makes it larger
out vec3 drawnNormal;
out vec3 drawnEye;   // to it

void placeDrawing() {
    mat3 axes = objectAxes();
    drawnPlace = meshToAxes(axes) * position;
    drawnNormal = worldNormal * axes;
    drawnEye = toEye * axes;
}
