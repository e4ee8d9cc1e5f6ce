// SPDX-License-Identifier: MIT-0
#include "lib/interface.glsl"

// Snell's law, into the pane and out of it.
vec3 thinPaneRefraction(Interface c, ThinPaneRefraction p) {
    return crossedDirection(c, vec3(p.index));
}

// Of both surfaces together, where a ray enters.
float thinPaneRefractionMirrored(Interface c, ThinPaneRefraction p) {
    return c.leaves ? 0.0 : paneReflectance(crossedReflectance(c, vec3(p.index)));
}

vec3 thinPaneRefractionLeft(float way, ThinPaneRefraction p) {
    return p.tint * leftAfter(way, p.absorptionColor, p.absorptionDistance);
}
