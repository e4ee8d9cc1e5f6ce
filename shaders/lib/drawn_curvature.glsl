// SPDX-License-Identifier: MIT-0
// How a surface bends, for models that draw on it.
#include "lib/drawn_place.glsl"

// A symmetric matrix, by which the unit normal changes along the surface, in 1/m.
struct DrawnBend {
    vec3 diagonal; // xx, yy, zz
    vec3 mixed;    // xy, yz, zx
};

DrawnBend drawnBend(vec3 diagonal, vec3 mixed) {
    DrawnBend bend;
    bend.diagonal = diagonal;
    bend.mixed = mixed;
    return bend;
}

// What the normal changes by along x.
vec3 bentAlong(DrawnBend bend, vec3 x) {
    vec3 d = bend.diagonal;
    vec3 m = bend.mixed;
    return vec3(d.x * x.x + m.x * x.y + m.z * x.z, m.x * x.x + d.y * x.y + m.y * x.z,
        m.z * x.x + m.y * x.y + d.z * x.z);
}

// A unit direction in the surface for lines, either way along it: that in which the surface bends
// the more, the curvatures being H + r and H - r, where one of them is clearly larger than the
// other and than `even`, in 1/m; elsewhere `way`, which is unit and in the surface. `follow` from 0
// to 1 is how much the first counts. Directions are added as twice their angles from `way`.
vec3 bendingWay(DrawnBend bend, vec3 n, vec3 way, float even, float follow) {
    vec3 beside = cross(n, way);
    vec3 by = bentAlong(bend, way);
    float along = dot(way, by);
    float across = dot(beside, bentAlong(bend, beside));
    float mean = 0.5 * (along + across);
    float x = 0.5 * (along - across);
    float y = dot(beside, by);
    float clear = 2.0 * follow * mean / (mean * mean + x * x + y * y + even * even);
    float twiceX = 0.125 + clear * x;
    float twiceY = clear * y;
    float size = sqrt(twiceX * twiceX + twiceY * twiceY);
    float c = twiceX > 0.0 ? size + twiceX : twiceY;
    float s = twiceX > 0.0 ? twiceY : size - twiceX;
    float inverse = 1.0 / max(sqrt(c * c + s * s), 1e-15);
    return (c * inverse) * way + (s * inverse) * beside;
}
