// SPDX-License-Identifier: MIT-0
// What an environment is asked.
#include "lib/elementary.glsl"
#include "lib/math.glsl"

struct SkyRay {
    vec3 d;       // unit, the way one looks; y is up
    vec3 picture; // what the environment's picture shows there, linear; white where it has none
};

// The angle around the vertical from +z towards +x, -pi .. pi; 0 straight up and down.
float azimuthOf(vec3 d) {
    float level = sqrt(d.x * d.x + d.z * d.z);
    if (!(level > 1e-6)) {
        return 0.0;
    }
    float angle = angleOf(abs(d.x) / level, abs(d.z) / level);
    angle = d.z < 0.0 ? PI - angle : angle;
    return d.x < 0.0 ? -angle : angle;
}

// The angle above the horizon, -pi/2 .. pi/2.
float elevationOf(vec3 d) {
    float angle = angleOf(abs(d.y), sqrt(d.x * d.x + d.z * d.z));
    return d.y < 0.0 ? -angle : angle;
}

// The angle between unit vectors, 0 .. pi, with every digit of a small one.
float angleBetween(vec3 a, vec3 b) {
    vec3 difference = a - b;
    vec3 sum = a + b;
    float apart = dot(difference, difference);
    return apart <= 2.0 ? sqrt(acos2(apart)) : PI - sqrt(acos2(min(dot(sum, sum), 2.0)));
}
