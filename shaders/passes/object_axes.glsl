// SPDX-License-Identifier: MIT-0
// An object's own axes in world space, and its mesh along them.

// Columns are unit and perpendicular, also where a shear slants the object: each column of the
// matrix to world space without what those before it have of it (Gram-Schmidt), on its own side.
mat3 objectAxes() {
    mat3 m = transpose(mat3(objectToWorld));
    vec3 x = m[0] * inversesqrt(max(dot(m[0], m[0]), 1e-30));
    vec3 y = m[1] - dot(m[1], x) * x;
    y *= inversesqrt(max(dot(y, y), 1e-30));
    vec3 z = cross(x, y);
    return mat3(x, y, dot(z, m[2]) < 0.0 ? -z : z);
}

// From the mesh to metres along the axes: scaled and sheared, not turned.
mat3 meshToAxes(mat3 axes) {
    return transpose(axes) * transpose(mat3(objectToWorld));
}
