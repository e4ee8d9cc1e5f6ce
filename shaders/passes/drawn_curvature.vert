// SPDX-License-Identifier: MIT-0
// How the surface bends at a vertex, along the object's axes and per metre of the object as it is
// scaled. A mesh without it has zeros, and so has one that is pressed flat.
#include "passes/object_axes.glsl"

layout(location = 12) in vec3 curvatureDiagonal; // xx, yy, zz
layout(location = 13) in vec3 curvatureMixed;    // xy, yz, zx

out vec3 drawnCurvature;
out vec3 drawnCurvatureMixed;

// For p' = M p a normal is n' = M^-T n / |M^-T n|, and changes by M^-T S M^-1 / |M^-T n|.
void placeCurvature() {
    mat3 toAxes = meshToAxes(objectAxes());
    mat3 back = abs(determinant(toAxes)) > 1e-30 ? inverse(toAxes) : mat3(0.0);
    vec3 across = normal * back;
    float size = sqrt(max(dot(across, across), 1e-30));
    mat3 bend = mat3(curvatureDiagonal.x, curvatureMixed.x, curvatureMixed.z,
        curvatureMixed.x, curvatureDiagonal.y, curvatureMixed.y,
        curvatureMixed.z, curvatureMixed.y, curvatureDiagonal.z);
    bend = transpose(back) * bend * back;
    drawnCurvature = vec3(bend[0].x, bend[1].y, bend[2].z) / size;
    drawnCurvatureMixed = vec3(bend[0].y, bend[1].z, bend[2].x) / size;
}
