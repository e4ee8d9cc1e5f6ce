// SPDX-License-Identifier: MIT-0
// How much of its surroundings a vertex sees past its own mesh.

// What passes/surface.vert's vertices have beside the rest: the mean of the free directions times
// their share, less the normal, in units of OPENNESS_UNIT; w: what is hidden from the back, from 1
// on. A mesh without it has (0, 0, 0, 1), as OpenGL gives it: nothing is hidden.
layout(location = 11) in vec4 packedOpenness;

const float OPENNESS_UNIT = 1.41421356 / 32767.0;

// The mean of the free directions less the normal, both unit, and the share that is free; zero and
// the back's share where that is seen. One vector for all: each costs every triangle something.
out vec4 openAround;

// In world space what is apart from the normal keeps its length under any scale.
void placeOpenness() {
    vec3 local = packedOpenness.xyz * OPENNESS_UNIT;
    vec3 apart = vec4(local, 0.0) * objectToWorld;
    apart *= sqrt(dot(local, local) / max(dot(apart, apart), 1e-30));
    vec3 seen = worldNormal + apart;
    float share = sqrt(dot(seen, seen));
    bool isHidden = dot(local, local) > 0.0;
    vec4 front = vec4(isHidden && share > 1e-3 ? seen / share - worldNormal : vec3(0.0),
        isHidden ? min(share, 1.0) : 1.0);
    vec4 back = vec4(vec3(0.0), 1.0 - (packedOpenness.w - 1.0) / 32766.0);
    openAround = dot(worldNormal, toEye) < 0.0 ? back : front;
}
