// SPDX-License-Identifier: MIT-0
// A transparent surface is added to a sum: colour times opacity and weight, and that weight.
// LAYER_RANGE holds the nearest depth and one over the way from there to the farthest.
#include "passes/surface.glsl"
#include "lib/layer.glsl"

Layer layerAt(float opacity) {
    Layer l;
    l.depth = clamp((1.0 / gl_FragCoord.w - LAYER_RANGE.x) * LAYER_RANGE.y, 0.0, 1.0);
    l.opacity = clamp(opacity, 0.0, 1.0);
    return l;
}

void storeLayer(vec3 color, float opacity, Transparency p) {
    Layer l = layerAt(opacity);
    float share = l.opacity * layerWeight(l, p);
    storedColor = share * vec4(storable(color.r), storable(color.g), storable(color.b), 1.0);
}
