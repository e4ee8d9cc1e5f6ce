// SPDX-License-Identifier: MIT-0
// From a mark's point on the surface to a rectangle that faces the viewer. All four corners have
// the point's own place and normal, so that the whole mark is lit as the point is.
#include "passes/surface.vert"
#include "lib/directions.glsl"
#include "lib/mark_point.glsl"

// x: how many marks stand on a square metre of the mesh when this one is the last of them; y: how
// fast the surface bends around it, in radians for each metre of the mesh, below 0 inwards.
layout(location = 12) in vec2 markSurface;

// Lengths are in units, of which the picture is so many high that a mark covers the same part of it
// in each of its sizes. xy: a unit in clip space; z: how wide it is one metre away, in metres; w:
// how many marks there are on a square metre of the mesh.
uniform vec4 markView;
uniform float markPixel; // how wide a pixel of the picture is, in units

out vec2 markPlace;       // along and across
flat out vec4 markRandom; // size, shade, phase, order
flat out vec3 markForm;   // the width of a pixel in widths of the mark, the aspect, the share that
                          // has faded in

// From being the last one to half as many more around it a mark fades in.
const float FADE = 2.0;

// Where marks are too few for the density they are larger, up to so many times.
const float MAX_GROWTH = 4.0;

const float MAX_SIZE = 4096.0;

// Marks that would be smaller are so many pixels wide, and fainter instead.
const float MIN_PIXELS = 1.5;

// The plane that touches the surface is followed up to this cosine between it and the viewer.
const float MIN_FACING = 0.03;

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

// A direction's ways to the right and up over the picture, in metres.
vec2 wayAcrossView(mat4 worldToClip, vec3 direction) {
    mat4 rows = transpose(worldToClip);
    vec3 ahead = safeNormalize(rows[3].xyz, vec3(0.0));
    vec3 right = rows[0].xyz - dot(rows[0].xyz, ahead) * ahead;
    vec3 up = rows[1].xyz - dot(rows[1].xyz, ahead) * ahead;
    return vec2(dot(direction, safeNormalize(right, vec3(0.0))),
        dot(direction, safeNormalize(up, vec3(0.0))));
}

// How far before the mark's point the surface may be at the place `beside` it on the picture, all
// in metres: the depths of the plane that touches the surface. Nothing of a flat surface lies
// before that, whichever way it faces. Near silhouettes the plane is all but a line to the viewer,
// and what bends away from it lies far behind: there it is the plane that touches a ball of the
// same bend halfway to where the mark comes nearest, which is before all of the ball and less
// steep.
float surfaceBefore(MarkPoint m, vec2 slope, vec2 beside, float reach) {
    float facing = clamp(dot(m.n, m.v), MIN_FACING, 1.0);
    float aside = sqrt(1.0 - facing * facing);
    float bend = max(markSurface.y, 0.0) * inversesqrt(max(areaHere(), 1e-30));
    float inward = min(0.5 * reach, aside / max(bend, 1e-20));
    float asideThere = max(aside - bend * inward, 0.0);
    float facingThere = sqrt(1.0 - asideThere * asideThere);
    float risen = inward * (aside + asideThere) / (facing + facingThere);
    float slopeThere = asideThere / facingThere;
    float part = asideThere / max(aside, 1e-6);
    part = aside > 1e-6 ? part : 1.0;
    return risen - slopeThere * inward - part / facingThere * dot(slope, beside);
}

// The depth at the place `beside` a mark's point on the picture, in metres, in clip space. What
// lies on the surface has that of the surface, what stands on it faces the viewer.
float markDepth(MarkPoint m, mat4 worldToClip, vec3 direction, vec2 along, vec2 size, vec2 beside) {
    vec2 slope = wayAcrossView(worldToClip, m.n);
    vec2 steepest = slope * inversesqrt(max(dot(slope, slope), 1e-12));
    vec2 sides = vec2(dot(steepest, along), dot(steepest, vec2(-along.y, along.x)));
    float reach = 0.5 * dot(size, abs(sides));
    float lying = 1.0 - min(abs(dot(direction, m.n)), 1.0);
    float before = lying * surfaceBefore(m, slope, beside, reach);
    // The triangles of a round surface lie beside it, and a hollow one before its plane.
    before += 0.05 * max(size.x, size.y);
    before += lying * (markSurface.y != 0.0 ? 0.5 : 0.0) * min(size.x, size.y);
    // On the way from there to the eye depths grow as one over the distance does.
    float range = sqrt(max(dot(toEye, toEye), 1e-30));
    float nearer = before / max(range + before, 0.1 * range);
    vec4 clip = worldToClip * vec4(worldPosition + nearer * toEye, 1.0);
    return clip.z / clip.w * gl_Position.w;
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
    float unit = max(gl_Position.w * markView.z, 1e-12);
    float density = MARK_SHARE * MARK_DENSITY(p) * areaHere() / (unit * unit);
    float wanted = density * clamp(strokesShare(m, p), 0.0, 1.0);
    if (!(gl_Position.w > 0.0) || !(wanted > markSurface.x)) {
        leaveMarkOut();
        return;
    }
    m.order = clamp(markSurface.x / min(density, markView.w), 0.0, 1.0);
    markRandom.w = m.order;
    float fade = clamp(FADE * (wanted / max(markSurface.x, 1e-20) - 1.0), 0.0, 1.0);
    float growth = min(sqrt(max(density / markView.w, 1.0)), MAX_GROWTH) * inversesqrt(MARK_SHARE);
    vec2 size = clamp(strokesSize(m, p) * growth, vec2(0.0), vec2(MAX_SIZE));
    if (!(min(size.x, size.y) > 0.0)) {
        leaveMarkOut();
        return;
    }
    mat4 worldToClip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]);
    vec3 direction = strokesAlong(m, p);
    vec2 way = wayOnPicture(worldToClip, direction);
    float seen = length(way);
    vec2 along = seen > 1e-6 ? way / seen : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    // What stands on the surface is seen shorter where it points to the viewer.
    size *= 0.5 + 0.5 * fade;
    size.x *= IS_STANDING ? clamp(seen, 0.2, 1.0) : 1.0;
    vec2 left = min(size / (MIN_PIXELS * markPixel), 1.0);
    size = max(size, vec2(MIN_PIXELS * markPixel));
    markForm = vec3(markPixel / size.y, size.x / size.y, fade * left.x * left.y);
    // A pixel at each side for the edges of the ink.
    vec2 grown = 1.0 + 2.0 * markPixel / size;
    markPlace = 0.5 + (markPlace - 0.5) * grown;
    vec2 offset = (markPlace.x - 0.5) * size.x * along + (markPlace.y - 0.5) * size.y * across;
    gl_Position.z = markDepth(m, worldToClip, direction, along, size * unit, offset * unit);
    gl_Position.xy += offset * markView.xy * gl_Position.w;
}
