// SPDX-License-Identifier: MIT-0
// What becomes of a surface's light under the marks that are set on it.

vec3 underMarks(Surface s, vec3 light, Strokes p) {
    MarkPoint m = MarkPoint(0.5, 0.5, 0.1, 1.0, s.n, s.t, s.v, light, 0.0, 0.5, 0.5, 0.5);
    return max(strokesUnder(m, p), vec3(0.0));
}
