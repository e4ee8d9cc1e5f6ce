// SPDX-License-Identifier: MIT-0
// The mean of all surfaces over what is behind them. McGuire and Bavoil 2013, equation 6.

uniform LAYER_IMAGE layerSum;
uniform LAYER_IMAGE layerShare;

layout(location = 0) out vec4 composed;

void main() {
    vec4 sum = texelFetch(layerSum, ivec2(gl_FragCoord.xy), LAYER_SAMPLE);
    float left = texelFetch(layerShare, ivec2(gl_FragCoord.xy), LAYER_SAMPLE).r;
    vec3 mean = sum.a > 0.0 ? min(sum.rgb / sum.a, vec3(65504.0)) : vec3(0.0);
    composed = vec4((1.0 - left) * mean, left);
}
