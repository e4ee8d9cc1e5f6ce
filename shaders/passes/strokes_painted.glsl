// SPDX-License-Identifier: MIT-0
// Marks that lie over each other like paint.

vec3 markInk(Surface s, vec3 light) {
    MarkPoint m = markHere(light);
    markAlpha = markShape * clamp(strokesOpacity(m, strokes), 0.0, 1.0);
    return max(strokesInk(m, strokes), vec3(0.0));
}
