// SPDX-License-Identifier: MIT-0
// From a mark's point on the surface to a rectangle that faces the viewer. All four corners have
// the point's own place and normal, so that the whole mark is lit as the point is.
#include "passes/surface.vert"
#include "lib/directions.glsl"
#include "lib/mark_point.glsl"

// How many marks stand on a square metre of the mesh when this one is the last of them.
layout(location = 12) in float markNeeded;

// xy: a pixel of the picture in clip space; z: how wide it is one metre away, in metres; w: how
// many marks there are on a square metre of the mesh.
uniform vec4 markView;

out vec2 markPlace;       // along and across
flat out vec4 markRandom; // size, shade, phase, order
flat out vec3 markForm;   // the width of a pixel in widths of the mark, the aspect, the share that
                          // has faded in

// From being the last one to half as many more around it a mark fades in.
const float FADE = 2.0;

// Where marks are too few for the density they are larger, up to so many times.
const float MAX_GROWTH = 4.0;

const float MAX_PIXELS = 4096.0;

// By the bits of the place (M. Jarzynski and M. Olano, Hash Functions for GPU Rendering, JCGT 9(3),
// 2020, pcg3d).
vec3 markNumbers() {
    uvec3 v = floatBitsToUint(position) * 1664525u + 1013904223u;
    for (int round = 0; round < 2; ++round) {
        v.x += v.y * v.z;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        v ^= round == 0 ? v >> 16u : uvec3(0u);
    }
    return vec3(v >> 8u) * (1.0 / 16777216.0);
}

// How much larger a patch of the surface is in the world than in the mesh.
float areaHere() {
    vec3 a = anyTangent(normal);
    vec3 b = cross(normal, a);
    return length(cross(vec4(a, 0.0) * objectToWorld, vec4(b, 0.0) * objectToWorld));
}

// The way of a direction in the world over the picture, for each metre, in metres at the mark's
// distance.
vec2 wayOnPicture(mat4 worldToClip, vec3 direction) {
    vec4 clip = worldToClip * vec4(direction, 0.0);
    vec2 way = (clip.xy - gl_Position.xy * (clip.w / gl_Position.w)) / markView.xy;
    return way * markView.z;
}

void leaveMarkOut() {
    markForm = vec3(1.0, 1.0, 0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}

void placeMark(Strokes p) {
    vec3 numbers = markNumbers();
    float range = sqrt(max(dot(toEye, toEye), 1e-30));
    MarkPoint m = MarkPoint(0.5, 0.5, 0.1, 1.0, worldNormal, worldTangent, toEye / range, vec3(0.0),
        1.0, numbers.x, numbers.y, numbers.z);
    m.t = safeNormalize(m.t - dot(m.t, m.n) * m.n, anyTangent(m.n));
    markPlace = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    markRandom = vec4(numbers, 1.0);
    float pixel = max(gl_Position.w * markView.z, 1e-12);
    float density = MARK_SHARE * MARK_DENSITY(p) * areaHere() / (pixel * pixel);
    float wanted = density * clamp(strokesShare(m, p), 0.0, 1.0);
    if (!(gl_Position.w > 0.0) || !(wanted > markNeeded)) {
        leaveMarkOut();
        return;
    }
    m.order = clamp(markNeeded / min(density, markView.w), 0.0, 1.0);
    markRandom.w = m.order;
    float fade = clamp(FADE * (wanted / max(markNeeded, 1e-20) - 1.0), 0.0, 1.0);
    float growth = min(sqrt(max(density / markView.w, 1.0)), MAX_GROWTH) * inversesqrt(MARK_SHARE);
    vec2 size = clamp(strokesSize(m, p) * growth, vec2(0.0), vec2(MAX_PIXELS));
    if (!(min(size.x, size.y) > 0.0)) {
        leaveMarkOut();
        return;
    }
    mat4 worldToClip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]);
    vec2 way = wayOnPicture(worldToClip, strokesAlong(m, p));
    float seen = length(way);
    vec2 along = seen > 1e-6 ? way / seen : vec2(1.0, 0.0);
    // What stands on the surface is seen shorter where it points to the viewer.
    size *= 0.5 + 0.5 * fade;
    size.x *= IS_STANDING ? clamp(seen, 0.2, 1.0) : 1.0;
    markForm = vec3(1.0 / size.y, size.x / size.y, fade);
    // A pixel at each side for the edges of the ink.
    vec2 grown = 1.0 + 2.0 / size;
    markPlace = 0.5 + (markPlace - 0.5) * grown;
    vec2 offset = (markPlace.x - 0.5) * size.x * along +
        (markPlace.y - 0.5) * size.y * vec2(-along.y, along.x);
    // A mark lies flat before the surface, so far in front of it that this does not cut it off.
    float lift = min((IS_STANDING ? 0.1 : 0.5) * max(size.x, size.y) * pixel, 0.5 * range);
    gl_Position = worldToClip * vec4(worldPosition + lift * m.v, 1.0);
    gl_Position.xy += offset * markView.xy * gl_Position.w;
    // The near plane may lie on the surface itself.
    gl_Position.z = max(gl_Position.z, -gl_Position.w);
}
