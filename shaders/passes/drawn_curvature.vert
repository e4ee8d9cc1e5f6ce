// SPDX-License-Identifier: MIT-0
// How the surface bends at a vertex, along the object's axes and per metre of the object as it is
// scaled. A mesh without it has zeros.
layout(location = 12) in vec3 curvatureDiagonal; // xx, yy, zz
layout(location = 13) in vec3 curvatureMixed;    // xy, yz, zx

out vec3 drawnCurvature;
out vec3 drawnCurvatureMixed;

// For p' = D p a normal is n' = D^-1 n / |D^-1 n|, and changes by D^-1 S D^-1 / |D^-1 n|.
void placeCurvature() {
    mat3 axes = transpose(mat3(objectToWorld));
    vec3 scale = max(vec3(length(axes[0]), length(axes[1]), length(axes[2])), vec3(1e-30));
    float size = max(length(normal / scale), 1e-30);
    drawnCurvature = curvatureDiagonal / scale / scale / size;
    drawnCurvatureMixed = curvatureMixed / scale.xyz / scale.yzx / size;
}
