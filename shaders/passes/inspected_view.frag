// SPDX-License-Identifier: MIT-0
// One thing of the surfaces on the screen in place of the picture: what storeInspected stored.

uniform sampler2D linearImage;
uniform float exposureFactor;
uniform int shown; // as in inspection.glsl: 1 energy, 2 normals, 3 tangents, 6 places, 7 Fresnel,
                   // 9 occlusion, 11 opacity

layout(location = 0) out vec4 displayed;

// The share above 1 that is the doubt of the estimate.
const float ALBEDO_DOUBT = 0.02;

// IEC 61966-2-1; clamped to 0 .. 1.
vec3 srgbEncoded(vec3 color) {
    vec3 x = clamp(color, vec3(0.0), vec3(1.0));
    vec3 power = 1.055 * pow(max(x, vec3(0.0031308)), vec3(1.0 / 2.4)) - vec3(0.055);
    return mix(power, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}

vec3 energyShown(vec3 albedo) {
    float largest = max(max(albedo.r, albedo.g), albedo.b);
    float above = largest - 1.0 - ALBEDO_DOUBT;
    // Grey by the strongest channel, so that nothing else is red.
    return above > 0.0 ? mix(vec3(0.75, 0.12, 0.1), vec3(1.0, 0.45, 0.3), min(above, 1.0))
                       : srgbEncoded(vec3(largest));
}

vec3 valueShown(vec3 value) {
    if (shown == 1) {
        return energyShown(value);
    }
    if (shown == 6) {
        return vec3(value.r, value.g, 0.0) * (0.75 + 0.25 * value.b);
    }
    if (shown == 7 || shown == 9 || shown == 11) { // a share, whatever the exposure
        return srgbEncoded(value);
    }
    return shown <= 3 ? vec3(0.5) + 0.5 * value : srgbEncoded(value * exposureFactor);
}

// Stripes: there is a surface, but the thing is not known of it.
vec3 unknownShown(vec2 place) {
    return vec3(fract((place.x + place.y) / 8.0) < 0.5 ? 0.35 : 0.42);
}

void main() {
    vec4 stored = texelFetch(linearImage, ivec2(gl_FragCoord.xy), 0);
    vec3 background = vec3(shown == 1 ? 0.93 : 0.25);
    vec3 surface = stored.a < 0.75 ? unknownShown(gl_FragCoord.xy) : valueShown(stored.rgb);
    displayed = vec4(stored.a < 0.25 ? background : surface, 1.0);
}
