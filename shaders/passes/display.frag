// SPDX-License-Identifier: MIT-0
// From linear light to what a display shows. exposed and toneMapped come from files before this one.

uniform sampler2D linearImage;

layout(location = 0) out vec4 displayed;

// IEC 61966-2-1; x in 0 .. 1.
float srgbEncoded(float x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

void main() {
    vec3 light = exposed(texelFetch(linearImage, ivec2(gl_FragCoord.xy), 0).rgb);
    vec3 shown = clamp(toneMapped(min(light, vec3(1e30))), vec3(0.0), vec3(1.0));
    displayed = vec4(srgbEncoded(shown.r), srgbEncoded(shown.g), srgbEncoded(shown.b), 1.0);
}
