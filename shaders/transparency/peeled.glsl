// SPDX-License-Identifier: MIT-0
#include "lib/layer.glsl"

// One layer at a time is drawn, and counts as it is. C. Everitt, Interactive order-independent
// transparency, NVIDIA 2001.
float peeledTransparency(Layer l, PeeledTransparency p) {
    return 1.0;
}
