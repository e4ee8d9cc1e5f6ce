// SPDX-License-Identifier: MIT-0
// Depths of the next layer. LAYER_IMAGE is a sampler of one or of several samples per pixel.

uniform LAYER_IMAGE nearerLayer;

// Depths that differ by no more are the same: so many steps of a float may lie between what the
// rasteriser stored and what it tells a shader.
const int SAME_DEPTH = 4;

// Whether the fragment belongs to the layer before, or lies in front of it.
bool isPeeled() {
    float nearer = texelFetch(nearerLayer, ivec2(gl_FragCoord.xy), LAYER_SAMPLE).r;
    return floatBitsToInt(gl_FragCoord.z) - floatBitsToInt(nearer) <= SAME_DEPTH;
}
