// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"
#include "lib/strand.glsl"

// A thin cylinder along d.t (Kajiya and Kay 1989, equations 14 and 16): diffuse light by the sine
// of the angle between it and the light, and a highlight around the cone onto which it mirrors. Its
// cosine sin(t, l) sin(t, v) - (t.l)(t.v) is that between two unit vectors of a plane, and so is
// one less it, without cancellation.
vec3 furShells(Directions d, FurShells p) {
    float sinL = sqrt(d.nl * d.nl + d.lb * d.lb);
    float sinV = sqrt(d.nv * d.nv + d.vb * d.vb);
    float versine = 0.5 * (sqr(sinL - sinV) + sqr(d.lt + d.vt));
    float lobe = pow1m(versine, 1.0 - versine, p.strandShininess);
    return p.strandColor * sinL + p.strandHighlight * lobe;
}

// An arc of a circle from the normal towards the direction of combing, as long as the strand: where
// it is after the share h of its length, bent by the angle a in all, is
//   n h sin(a h) / (a h) + c h (1 - cos(a h)) / (a h).
vec3 furShellsOffset(Strand s, FurShells p) {
    vec3 aside = p.combDirection - dot(p.combDirection, s.n) * s.n;
    float lean = sqrt(dot(aside, aside));
    float bend = 0.5 * PI * p.comb / max(lean, 1.0);
    float x = bend * lean * s.height;
    float up = x > 1e-3 ? sin(x) / x : 1.0 - x * x / 6.0;
    float over = x > 1e-3 ? versineOf(x) / (x * x) : 0.5 - x * x / 24.0;
    return p.strandLength * s.height * (up * s.n + over * bend * s.height * aside);
}

// Half of the width, falling to the tip and round at its end.
float furShellsRadius(Strand s, FurShells p) {
    float own = 1.0 - p.variation * s.size;
    float left = own - s.height;
    if (!(left > 0.0)) {
        return 0.0;
    }
    float share = left / own;
    return 0.5 * p.thickness * (1.0 - p.taper * (1.0 - share)) * min(8.0 * share, 1.0);
}

// A helix that widens from the root on.
vec2 furShellsCurl(Strand s, FurShells p) {
    float turns = p.curlTurns * s.height + s.phase;
    float angle = 2.0 * PI * (turns - floor(turns));
    float reach = 0.5 * p.curl * s.height;
    return vec2(reach * cos(angle), reach * sin(angle));
}

// What strands above leave of the light, by Bouguer's law, on the strand's own colour. Light along
// the surface comes no farther than from twenty lengths away.
vec3 furShellsTint(Strand s, FurShells p) {
    float depth = p.shadow * (1.0 - s.height) / max(s.nl, 0.05);
    float left = exp(-depth) * (1.0 - p.toneVariation * s.shade);
    return lerp(p.rootColor, p.tipColor, s.height) * left;
}
