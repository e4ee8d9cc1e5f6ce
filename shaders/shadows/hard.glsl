// SPDX-License-Identifier: MIT-0

// L. Williams, Casting curved shadows on curved surfaces, SIGGRAPH 1978, with the comparisons of
// the four texels around blended.
float hardShadow(ShadowPoint s, HardShadow p) {
    return shadowLit(s, vec2(0.0));
}
