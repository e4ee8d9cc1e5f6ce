// SPDX-License-Identifier: MIT-0

// The straight way from the eye to a surface, in world space.
struct FogRay {
    vec3 eye;
    vec3 direction; // unit, from the eye
    float range;    // metres, >= 0
};
