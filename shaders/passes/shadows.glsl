// SPDX-License-Identifier: MIT-0
// A point that catches shadows, and the map of the light that may not reach it.
#include "lib/directions.glsl"
#include "lib/math.glsl"

// One layer, or six, for each light that casts shadows: depths as the light sees them.
uniform sampler2DArray shadowMaps;

// How a light's map looks at the scene. Where nothing casts shadows the window is nowhere.
struct ShadowView {
    vec3 right;   // unit; of a light from very far away over the metres that the map spans
    vec3 up;
    vec3 forward; // the way the light travels; likewise, over the metres that depths span
    vec3 origin;  // the light, or for a light from very far away the map's corner, nearest to it
    vec4 window;  // scale and shift of slopes into the map; of a light from far away x: its metres
    float near;   // depths, metres along forward
    float far;
    float size;   // metres: the longest side of the box around all that casts
    float texel;  // metres a texel spans, for a light with a place one metre in front of it
    float layer;
    float faces;  // 1, or 6: forward, backward, right, left, up, down
};

// SHADOW_DATA(i) is vec4 i from `base` on.
ShadowView shadowViewAt(int base) {
    ShadowView view;
    view.right = SHADOW_DATA(0).xyz;
    view.texel = SHADOW_DATA(0).w;
    view.up = SHADOW_DATA(1).xyz;
    view.layer = SHADOW_DATA(1).w;
    view.forward = SHADOW_DATA(2).xyz;
    view.faces = SHADOW_DATA(2).w;
    view.origin = SHADOW_DATA(3).xyz;
    view.near = SHADOW_DATA(3).w;
    view.window = SHADOW_DATA(4);
    view.far = SHADOW_DATA(5).x;
    view.size = SHADOW_DATA(5).y;
    return view;
}

struct ShadowPoint {
    ShadowView view;
    bool isParallel;
    vec3 x;             // on the surface, lifted by what its map can be wrong about it
    vec3 n;             // unit normal of the triangle, on the light's side
    vec3 l;             // unit, to the light
    vec3 across;        // unit, at right angles to l and to each other
    vec3 along;
    float inverseRange; // 1 / metres to the light; 0: the light is very far away
    float texel;        // metres a texel spans here
    float turn;         // of the pixel's pattern of places, radians
    float rise;         // metres by which its surface may rise for each metre beside it
};

// Light that comes in flatter is taken as this: what is left of it is too little to see.
const float MIN_SHADOWED_NL = 0.002;

// A number in 0 .. 1 for each pixel, as different as can be from its neighbours' (J. Jimenez, Next
// Generation Post Processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014).
float pixelNoise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

// The normals of the triangle itself and of the mesh, without any image: set before the lights.
vec3 shadowFace;
vec3 shadowLift;

// How many metres of a surface a pixel shows, on the inside of a body: that is looked up so much
// farther in, as a pixel at the body's edge may lie beyond it. Below zero elsewhere.
float shadowAside;

float shadowInset(vec3 v) {
    vec3 across = dFdx(toEye);
    vec3 along = dFdy(toEye);
    float pixel = sqrt(2.0 * (dot(across, across) + dot(along, along)));
    return isSeenFromBehind(v) ? pixel : -1.0;
}

// The sine of the angle between a normal and the axis of the map's face that a light with a place
// sees it by: depths are measured along that, so a surface that faces the light may lie aslant.
float shadowFaceSlant(vec3 n, vec3 way, ShadowView view) {
    vec3 size = abs(vec3(dot(way, view.right), dot(way, view.up), dot(way, view.forward)));
    vec3 axis = size.x >= size.y ? view.right : view.up;
    axis = view.faces < 2.0 || size.z >= max(size.x, size.y) ? view.forward : axis;
    return safeSqrt(1.0 - sqr(dot(n, axis)));
}

// The slope by which a surface may rise above its own plane, away from the point, without shading
// itself: the few degrees between the triangles of a hollow.
const float SHADOWED_RISE = 0.08;

// Metres along the light's way by which a surface that bends towards the light by this slope rises
// above its own plane, for each metre beside the point; at most that of one at 80 degrees.
float shadowedRise(ShadowPoint s, float slope) {
    float nl = max(dot(s.l, s.n), 0.17);
    return slope / (nl * (nl + slope * safeSqrt(1.0 - sqr(nl))));
}

// Lifted along the normal of the mesh by one and a half texels times that sine: that is by how much
// a level surface differs from itself within the four texels that are read.
ShadowPoint shadowPoint(Surface s, vec3 l, ShadowView view, bool isParallel) {
    ShadowPoint p;
    p.view = view;
    p.isParallel = isParallel;
    float missing = MIN_SHADOWED_NL - dot(shadowFace, l);
    p.n = missing > 0.0 ? normalize(shadowFace + missing * l) : shadowFace;
    p.l = l;
    p.across = isParallel ? view.window.x * view.right : tangentAlong(l, vec3(1.0, 0.0, 0.0));
    p.along = isParallel ? view.window.x * view.up : cross(l, p.across);
    vec3 way = s.x - view.origin;
    float range = max(length(way), 1e-6);
    p.inverseRange = isParallel ? 0.0 : 1.0 / range;
    p.texel = isParallel ? view.texel : view.texel * range;
    float nl = max(dot(shadowFace, l), MIN_SHADOWED_NL);
    float slant = safeSqrt(1.0 - sqr(nl));
    float lift = isParallel ? slant : max(slant, shadowFaceSlant(shadowFace, way, view));
    p.x = s.x + shadowLift * (p.texel * (0.25 + 1.5 * lift));
    if (shadowAside >= 0.0) {
        vec3 inwards = shadowFace - dot(shadowFace, l) * l;
        float inset = 2.0 * p.texel + min(shadowAside, 8.0 * p.texel);
        p.x += inwards * (inset / max(slant, 0.01));
    }
    p.turn = 2.0 * PI * pixelNoise();
    p.rise = shadowedRise(p, SHADOWED_RISE);
    return p;
}

// A way from the light towards the surface's own plane.
struct ShadowRay {
    vec3 place;    // in the maps: 0 .. 1 across and up, layer
    float depth;   // of the plane, metres along the map's view, less what they are rounded by
    float stored;  // the same, less the doubt, as maps have it
    float stretch; // metres along the ray for each of those
    float doubt;   // metres along the view that are nothing
};
