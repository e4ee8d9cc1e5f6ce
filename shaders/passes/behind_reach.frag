// SPDX-License-Identifier: MIT-0
// How near and how far what is solid in each tile of a picture reaches, for rays that skip the tile
// (passes/refraction_behind.glsl). A tile has 2 x 2 texels of a level of the depths: the lower left
// one holds the nearest depth, the one on its right the farthest. The upper ones hold nothing.

uniform sampler2D behindDepth; // whose first level alone is read
uniform ivec2 behindSize;      // of the picture, in pixels
uniform int behindLevel;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 first = texel / 2 * (2 << behindLevel);
    ivec2 end = min(first + (2 << behindLevel), behindSize);
    bool isFarthest = texel.x % 2 == 1;
    float reach = isFarthest ? 0.0 : 1.0;
    for (int y = first.y; y < end.y && texel.y % 2 == 0; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            float depth = texelFetch(behindDepth, ivec2(x, y), 0).r;
            reach = isFarthest ? max(reach, depth) : min(reach, depth);
        }
    }
    gl_FragDepth = reach;
}
