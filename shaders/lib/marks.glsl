// SPDX-License-Identifier: MIT-0
// Marks of ink on paper, for models that draw. Lengths are pixels of the picture.
#include "lib/math.glsl"

// How much of a pixel's width lies inside a mark whose edge is `inside` away, towards its inside.
float inked(float inside) {
    return clamp(inside + 0.5, 0.0, 1.0);
}

// The place in axes that are turned by `angle`, in radians.
vec2 turnedPlace(vec2 place, float angle) {
    float c = cos(angle);
    float s = sin(angle);
    return vec2(c * place.x + s * place.y, c * place.y - s * place.x);
}

// How far x is from the nearest whole number, 0 .. 0.5.
float offWhole(float x) {
    return abs(x - floor(x + 0.5));
}

// How dark a surface is drawn: 0 where n.l is at least `light`, 1 where it is at most `dark`. Both
// at one place is a hard edge, 0.001 wide.
float darkness(float nl, float dark, float light) {
    return clamp((light - nl) / max(light - dark, 1e-3), 0.0, 1.0);
}
