// SPDX-License-Identifier: MIT-0
// Marks of ink on paper, for models that draw. Lengths are pixels of the picture. A vec2 has what
// is inked and what is bare, each as it comes, so that neither is a difference of the other.
#include "lib/directions.glsl"
#include "lib/math.glsl"

// How much of a pixel's width lies inside a mark whose edge is `inside` away, towards its inside,
// and how much outside.
vec2 inked(float inside) {
    return vec2(clamp(0.5 + inside, 0.0, 1.0), clamp(0.5 - inside, 0.0, 1.0));
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

// How dark and how bright a surface is drawn, together 1: all dark where n.l is at most `dark`, all
// bright where it is at least `light`. Both at one place is a hard edge, 0.001 wide. How far n.l is
// below `light` and above `dark` comes from 1 - n.l where that is the small one: a narrow edge
// multiplies what is lost.
vec2 tones(Directions d, float dark, float light) {
    float width = max(light - dark, 1e-3);
    bool facing = d.versineL < 0.5;
    float below = facing ? d.versineL - (1.0 - light) : light - d.nl;
    float above = facing ? (1.0 - dark) - d.versineL : d.nl - dark;
    float lead = width > 1e-3 ? above : width - below;
    return vec2(clamp(below / width, 0.0, 1.0), clamp(lead / width, 0.0, 1.0));
}

// Ink with the strength f of a mark, where 1 - f is given too so that it is no difference.
vec2 faded(vec2 mark, float strength, float missing) {
    return vec2(strength * mark.x, missing + strength * mark.y);
}

// A line of any width whose middle is `aside` away. The ramps of its edges make a line of w < 1
// pixels ((w + 1) / 2)^2 wide, which the strength takes away again.
vec2 lineMark(float width, float aside) {
    vec2 mark = inked(0.5 * width - aside);
    float drawn = sqr(0.5 * width + 0.5);
    return width < 1.0 ? faded(mark, width / drawn, sqr(0.5 - 0.5 * width) / drawn) : mark;
}
