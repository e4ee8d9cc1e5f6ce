// SPDX-License-Identifier: MIT-0
// Where a picture of all directions lies that has levels, each half as wide as the last: on the faces
// of an octahedron, unfolded to a square with +z in its middle (Cigolle et al. 2014, A Survey of
// Efficient Representations for Independent Unit Vectors, JCGT 3(2)), so that the horizon, where most
// environments have an edge, runs along texels and shows no teeth. Level 0 stands on the left, the
// others one upon another on its right. A texel around each level repeats what lies on the other side
// of the fold, so that looking up between texels knows no seam.

const float OCTAHEDRAL_WIDTH = float(OCTAHEDRAL_TEXELS); // of level 0, with the texels around it

// Beside level 2: what a matte surface shows.
const float MATTE_SHARE = float(MATTE_TEXELS) / OCTAHEDRAL_WIDTH;
const vec2 MATTE_ORIGIN = vec2(MATTE_TEXEL_ORIGIN) / OCTAHEDRAL_WIDTH;

float octahedralSign(float x) {
    return x < 0.0 ? -1.0 : 1.0;
}

vec2 octahedralFold(vec2 p) {
    return vec2((1.0 - abs(p.y)) * octahedralSign(p.x), (1.0 - abs(p.x)) * octahedralSign(p.y));
}

// Of a direction of any length; both from 0 to 1.
vec2 octahedralPlace(vec3 d) {
    vec2 p = d.xy / max(abs(d.x) + abs(d.y) + abs(d.z), 1e-30);
    return 0.5 + 0.5 * (d.z < 0.0 ? octahedralFold(p) : p);
}

// The unit direction of a place in the square or a little beside it.
vec3 octahedralDirection(vec2 place) {
    vec2 p = 2.0 * place - 1.0;
    vec2 over = step(vec2(1.0), abs(p));
    p = mix(p, 2.0 * vec2(octahedralSign(p.x), octahedralSign(p.y)) - p, over);
    p *= 1.0 - 2.0 * over.yx; // beyond an edge it goes on from the edge's other half
    float height = 1.0 - abs(p.x) - abs(p.y);
    vec2 q = height < 0.0 ? octahedralFold(p) : p;
    return normalize(vec3(q, height));
}

// The same of a place in level 0, in its texels.
vec3 octahedralDirectionAt(vec2 texel) {
    return octahedralDirection((texel - 1.0) / (OCTAHEDRAL_WIDTH - 2.0));
}

// Where a level begins, in widths of level 0.
vec2 octahedralOrigin(float share) {
    return share < 1.0 ? vec2(1.0, 1.0 - 2.0 * share) : vec2(0.0);
}

// Where a place of a level lies, in widths of level 0: of the level that begins at `origin` and is
// `share` as wide as level 0. The texture is 1.5 by 1 of these.
vec2 octahedralLevel(vec2 place, vec2 origin, float share) {
    return origin + 1.0 / OCTAHEDRAL_WIDTH + place * (share - 2.0 / OCTAHEDRAL_WIDTH);
}
