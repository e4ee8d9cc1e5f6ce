// SPDX-License-Identifier: MIT-0
#include "lib/illumination.glsl"

// What the model sends to the viewer from one light, wherever that is. A surface's normal is turned
// towards the viewer, who is never below its horizon.
vec3 litAnyway(Surface s, Illumination light, Model p) {
    Directions d = directionsAt(s, light.l, s.v);
    return light.radiance * CUT_AT_ZERO(shadeModel(d, p));
}

// Nothing else is computed for a light that is below the horizon.
vec3 lit(Surface s, Illumination light, Model p) {
    if (IS_UNLIT(dot(s.n, light.l))) {
        return vec3(0.0);
    }
    return litAnyway(s, light, p);
}

// From a light with an end or with shadows. Where nothing arrives the model is not asked.
vec3 litWhereItArrives(Surface s, Illumination light, Model p) {
    float brightest = max(max(light.radiance.r, light.radiance.g), light.radiance.b);
    if (!(brightest > 0.0) || IS_UNLIT(dot(s.n, light.l))) {
        return vec3(0.0);
    }
    return litAnyway(s, light, p);
}
