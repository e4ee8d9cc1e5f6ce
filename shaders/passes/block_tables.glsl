// SPDX-License-Identifier: MIT-0
// The tables that blocks of the material read in place of computing, one above the other. An entry
// has a texel; between entries stands their mean, at whatever precision filters have.
uniform sampler2D blockTables;

vec3 tableEntry(int column, int row) {
    return texelFetch(blockTables, ivec2(column, row), 0).rgb;
}

// x 0 .. 1, from the first to the last of the entries in the row.
vec3 readTableLine(float x, int entries, int row) {
    float at = clamp(x, 0.0, 1.0) * float(entries - 1);
    int low = clamp(int(at), 0, entries - 2);
    return mix(tableEntry(low, row), tableEntry(low + 1, row), at - float(low));
}

// The same of a table of two axes, whose first row is given.
vec3 readTablePlane(vec2 x, ivec2 entries, int row) {
    vec2 at = clamp(x, 0.0, 1.0) * vec2(entries - 1);
    ivec2 low = clamp(ivec2(at), ivec2(0), entries - 2);
    vec2 share = at - vec2(low);
    vec3 below = mix(tableEntry(low.x, row + low.y), tableEntry(low.x + 1, row + low.y), share.x);
    vec3 above = mix(tableEntry(low.x, row + low.y + 1), tableEntry(low.x + 1, row + low.y + 1),
        share.x);
    return mix(below, above, share.y);
}
