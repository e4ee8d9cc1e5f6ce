// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"

// Gooch, Gooch, Shirley and Cohen, A Non-Photorealistic Lighting Model for Automatic Technical
// Illustration, SIGGRAPH 1998, equation 2: u warm + (1 - u) cool, u = (1 + n.l) / 2. Their print
// has l away from the light. With two lights (their approximation) the mean of both tones is lit by
// a warm light from l and a cool one from -l; negative lights are left out, so no tone is darkened.
// u goes through the tone response.
vec3 goochTone(Directions d, Gooch p, vec3 warm, vec3 cool) {
    float towards = 0.5 * d.vercosineL;
    float away = 0.5 * d.versineL;
    float lead = d.nl;
    if (!p.toneCurveLinear) {
        towards = goochToneCurve(towards, p);
        away = 1.0 - towards;
        lead = towards - away;
    }
    if (p.blending == GOOCH_BLENDING_PRINTED) {
        return towards * cool + away * warm;
    }
    if (p.lights == GOOCH_LIGHTS_TWO) {
        vec3 difference = 0.5 * (warm - cool);
        return 0.5 * (warm + cool) + max(difference, vec3(0.0)) * max(lead, 0.0)
            + max(-difference, vec3(0.0)) * max(-lead, 0.0);
    }
    return towards * warm + away * cool;
}

vec3 gooch(Directions d, Gooch p) {
    vec3 warm = p.warmColor + p.warmMix * p.diffuseColor;
    vec3 cool = p.coolColor + p.coolMix * p.diffuseColor;
    vec3 ambient = p.ambientColor;
    if (p.ambientRule == GOOCH_AMBIENT_RULE_RAW) {
        ambient = 0.5 * (p.warmColor + p.coolColor);
    }
    if (p.ambientRule == GOOCH_AMBIENT_RULE_MIXED) {
        ambient = 0.5 * (warm + cool);
    }
    vec3 highlight = vec3(0.0);
    if (d.nl > 0.0) {
        highlight = slotSpecular(d, p.specular);
    }
    return goochTone(d, p, warm, cool) + p.ambientAmount * ambient + highlight;
}
