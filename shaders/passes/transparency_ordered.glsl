// SPDX-License-Identifier: MIT-0
// Layers in their order over what is behind them: their light, and the share that they transmit.

uniform LAYER_IMAGE layerSum;

layout(location = 0) out vec4 composed;

void main() {
    vec4 layers = texelFetch(layerSum, ivec2(gl_FragCoord.xy), LAYER_SAMPLE);
    composed = vec4(min(layers.rgb, vec3(65504.0)), layers.a);
}
