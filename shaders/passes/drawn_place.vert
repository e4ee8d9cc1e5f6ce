// SPDX-License-Identifier: MIT-0
// Where a vertex is along the object's axes, for models that draw on the surface.

out vec3 drawnPlace; // metres; a scale of the object makes it larger
out vec3 drawnNormal;
out vec3 drawnEye;   // to it

void placeDrawing() {
    mat3 axes = transpose(mat3(objectToWorld));
    vec3 scale = vec3(length(axes[0]), length(axes[1]), length(axes[2]));
    axes = mat3(axes[0] / max(scale.x, 1e-30), axes[1] / max(scale.y, 1e-30),
        axes[2] / max(scale.z, 1e-30));
    drawnPlace = position * scale;
    drawnNormal = worldNormal * axes;
    drawnEye = toEye * axes;
}
