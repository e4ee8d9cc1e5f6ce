// SPDX-License-Identifier: MIT-0
// A point of a surface as the lights find it, in whatever stage it is shaded.
#include "passes/blocks.glsl"
#include "lib/directions.glsl"
#include "lib/math.glsl"

layout(std140) uniform SceneBlock {
    vec4 sceneData[SCENE_VEC4S];
};

// The smallest n.v that is shaded. Interpolated normals of a coarse mesh point away from the
// viewer near its outline, where every model is 0 and black pixels would line it; they are turned
// towards the viewer to 0.6 degrees above the horizon.
const float MIN_NV = 0.01;

struct Surface {
    vec3 x;         // in world space
    vec3 v;         // unit, to the eye
    float range;    // metres from the eye
    vec3 n;         // unit normal on the viewer's side
    vec3 t;         // unit tangents, orthogonal to n and to each other
    vec3 b;
    vec2 pixel;     // of the picture, whatever the target's fineness
};

vec3 towardsViewer(vec3 n, vec3 v) {
    float missing = MIN_NV - dot(n, v);
    return missing > 0.0 ? normalize(n + missing * v) : n;
}

// The same for an n of at most length 1, blended of unit ones, made unit by one root. MIN_NV is
// kept towards the viewer whatever the length of n is, which is no less than that share of it, and
// enough for nothing to cancel where n is -v or zero, which gives v. Only on slivers, thinner than
// the 1/256 pixel to which devices place vertices, n may be somewhat longer, and the share less.
// 1e-36 is there for a v of zero, at the eye itself.
vec3 unitTowardsViewer(vec3 n, vec3 v) {
    vec3 turned = n + max(MIN_NV - dot(n, v), 0.0) * v;
    return turned * inversesqrt(dot(turned, turned) + 1e-36);
}

// The unit tangent along t, at most of length 1, perpendicular to the unit normal n: t - (t.n) n,
// which the second pass frees from what the first rounding left along n. Where t is zero or within
// 1e-6 rad of n it says nothing about a direction in the surface and any tangent serves.
vec3 tangentBeside(vec3 n, vec3 t) {
    vec3 p = t - dot(t, n) * n;
    vec3 w = p - dot(p, n) * n;
    float length2 = dot(w, w);
    vec3 unit = w * inversesqrt(max(length2, 1e-12));
    return length2 > 1e-12 ? unit : anyTangent(n);
}

Directions directionsAt(Surface s, vec3 l, vec3 v) {
    Directions d = directions(s.n, s.t, s.b, l, v);
    d.pixel = s.pixel;
    return d;
}
