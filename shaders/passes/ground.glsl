// SPDX-License-Identifier: MIT-0
// The ground in place of a model: a white matt surface whose colour comes last.
#include "passes/surface.glsl"

struct Model {
    float unused;
};

Model unpackModel(int base) {
    Model p;
    p.unused = 0.0;
    return p;
}

vec3 shadeModel(Directions d, Model p) {
    return vec3(max(d.nl, 0.0));
}

// How much of the ground is there: it fades where its disk ends, long after the last object.
float groundShare() {
    vec2 beside = worldPosition.xz - objectData[GROUND + 1].xy;
    float share = length(beside) * objectData[GROUND + 1].z;
    return objectData[GROUND].w * (1.0 - smoothstep(0.4, 1.0, share));
}
