// SPDX-License-Identifier: MIT-0
// A surface of parallel round ridges: cylinders of radius 1, `spacing` d >= 2 apart, whose axes lie
// at height 0 along t, standing in a floor at the height h = -1 .. 1. After P. Poulin and A.
// Fournier, A Model for Anisotropic Reflection, SIGGRAPH 1990; the closed forms are derived for
// what is lit and seen at once in the plane across the ridges. An angle psi there is measured from
// n towards b.
#include "lib/elementary.glsl"
#include "lib/math.glsl"

// A direction as seen in that plane, at the angle phi from n.
struct AcrossRidges {
    float cosine;  // cos phi > 0
    float sine;    // |sin phi|
    float horizon; // eta = pi/2 - |phi|, its height over the horizon
    float side;    // 1 where it comes from the side of +b, else -1
    float across;  // the length of its unit vector in the plane
};

// From the components n > 0 and b of the direction, whose squares a float may not hold.
AcrossRidges acrossRidges(float n, float b) {
    AcrossRidges a;
    float largest = max(n, abs(b));
    float x = n / largest;
    float y = abs(b) / largest;
    float size = sqrt(x * x + y * y);
    a.across = largest * size;
    a.cosine = x / size;
    a.sine = y / size;
    a.horizon = angleOf(a.cosine, a.sine);
    a.side = b < 0.0 ? -1.0 : 1.0;
    return a;
}

// u - sin(u) for 0 <= u <= pi; the series below 1/2 keeps the digits of a short arc.
float excessOverSine(float u) {
    float w = u * u;
    if (u < 0.5) {
        return u * w / 6.0 * (1.0 - w / 20.0 * (1.0 - w / 42.0 * (1.0 - w / 72.0
            * (1.0 - w / 110.0))));
    }
    return u - sin(u);
}

// The arc psi = x .. y of a ridge that a direction reaches: from where it grazes the ridge, at
// psi = phi -+ pi/2, over 2 asin(sqrt(d cos phi / 2)), where the next ridge's shadow begins; the
// floor leaves |psi| <= acos(h). Empty where y < x.
vec2 ridgeArc(AcrossRidges a, float spacing, float height) {
    float x = min(0.5 * spacing * a.cosine, 1.0);
    float width = 2.0 * angleOf(sqrt(x), sqrt(1.0 - x));
    float end = angleOf(sqrt((1.0 - height) * (1.0 + height)), abs(height));
    if (height < 0.0) {
        end = PI - end;
    }
    float low = a.side > 0.0 ? -a.horizon : a.horizon - width;
    return vec2(max(low, -end), min(low + width, end));
}

vec2 commonArc(vec2 a, vec2 b) {
    return vec2(max(a.x, b.x), min(a.y, b.y));
}

// The integral of cos(psi - phi_l) cos(psi - phi_v) over the arc. With the heights over the horizon
// both cosines are sines, A = eta_l + side psi and B alike, and the integral is, at the middle of
// an arc of length u, u sin A sin B +- (u - sin u) cos(A +- B) / 2, which keeps short arcs exact.
float ridgeFacing(AcrossRidges l, AcrossRidges v, vec2 arc) {
    float u = arc.y - arc.x;
    if (!(u > 0.0)) {
        return 0.0;
    }
    float middle = 0.5 * (arc.x + arc.y);
    float A = l.horizon + l.side * middle;
    float B = v.horizon + v.side * middle;
    float turn = l.side * v.side;
    return max(u * sin(A) * sin(B) + 0.5 * turn * excessOverSine(u) * cos(A + turn * B), 0.0);
}

// The strip x .. y of the floor, of 0 .. d between two axes, that a direction reaches. A tangent to
// a ridge meets the floor (1 -+ h |sin phi|) / cos phi from its axis, on the far and the near side;
// where it touches the ridge below the floor, the ridge's own foot sqrt(1 - h^2) ends the strip.
vec2 floorStrip(AcrossRidges a, float spacing, float height) {
    float foot = sqrt((1.0 - height) * (1.0 + height));
    float c = max(a.cosine, 1e-20);
    float rise = height * c / (1.0 + a.sine); // h (1 - |sin phi|) / cos phi
    float shadow = height >= a.sine ? foot : (1.0 - height) / c + rise;
    float overhang = height <= -a.sine ? (1.0 + height) / c - rise : foot;
    return a.side > 0.0 ? vec2(overhang, spacing - shadow) : vec2(shadow, spacing - overhang);
}
