// SPDX-License-Identifier: MIT-0
// From an edge near the silhouette to a fin: a strip that stands on it, as high as the strands.
// What the skin's vertices hand on stands before it, with passOn(), which hands it on again.

layout(triangle_strip, max_vertices = 10) out;

in mat4x3 finOffset[];

out float finShare; // how much of the strands on the fin is there

// Up to this cosine between the surface and the viewer fins stand; towards it they fade in, so
// that none appears of a sudden.
const float FIN_COSINE = 0.35;

float shareAt(int corner) {
    vec3 v = skinToEye[corner];
    float c = abs(dot(skinWorldNormal[corner], v)) * inversesqrt(max(dot(v, v), 1e-30));
    return clamp(2.0 - 2.0 * c / FIN_COSINE, 0.0, 1.0);
}

void emitFin(int corner, int level, float share) {
    vec3 offset = level == 0 ? vec3(0.0) : finOffset[corner][max(level - 1, 0)];
    passOn(corner);
    worldPosition = skinWorldPosition[corner] + offset;
    toEye = skinToEye[corner] - offset;
    shellHeight = 0.25 * float(level);
    finShare = share;
    mat4 worldToClip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]);
    gl_Position = worldToClip * vec4(worldPosition, 1.0);
    EmitVertex();
}

void drawFin() {
    float from = shareAt(1);
    float to = shareAt(2);
    if (max(from, to) > 0.0) {
        for (int level = 0; level <= 4; ++level) {
            emitFin(1, level, from);
            emitFin(2, level, to);
        }
        EndPrimitive();
    }
}
