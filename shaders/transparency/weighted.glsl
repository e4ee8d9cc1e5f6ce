// SPDX-License-Identifier: MIT-0
#include "lib/layer.glsl"

// The least that a surface counts: McGuire and Bavoil's 1e-2 to 3e3.
const float MIN_WEIGHT = 3.3e-6;

// The opacity times (1 - depth)^falloff. M. McGuire and L. Bavoil, Weighted blended order-independent
// transparency, JCGT 2(2), 2013, equation 10, with depths from the nearest to the farthest surface.
float weightedTransparency(Layer l, WeightedTransparency p) {
    return l.opacity * max(pow(max(1.0 - l.depth, MIN_WEIGHT), p.falloff), MIN_WEIGHT);
}
