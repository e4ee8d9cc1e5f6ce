// SPDX-License-Identifier: MIT-0
// The model between lit.glsl or ambient.glsl and its own function, here modelValue. What leaves only
// the highlight of its parameters, leaveHighlight, is generated; HAS_TERMS says whether it can.
#include "passes/inspection.glsl"
#include "lib/illumination.glsl"

uniform sampler2D albedoTable;

vec3 inspectedModel(Directions d, Model p) {
    modelled = modelValue(d, p);
    lookAt(modelled);
    if (HAS_TERMS && (shown == SHOWN_DIFFUSE || shown == SHOWN_HIGHLIGHT)) {
        leaveHighlight(p);
        vec3 highlight = max(modelValue(d, p), vec3(0.0));
        modelledTerm = shown == SHOWN_HIGHLIGHT ? highlight : max(modelled - highlight, vec3(0.0));
    }
    return modelled;
}

// How much of a uniform white sky the surface sends to the viewer, from the table that
// albedo_table.glsl fills: across, the root of n.v; up, the viewer's azimuth from the tangent.
vec4 albedoAt(Surface s) {
    float azimuth = atan(dot(s.v, s.b), dot(s.v, s.t)) / (2.0 * PI);
    return vec4(texture(albedoTable, vec2(safeSqrt(dot(s.n, s.v)), azimuth)).rgb, 1.0);
}

Illumination inspectedLight(Illumination light) {
    lookAt(light.radiance);
    lookAt(abs(light.l));
    modelled = vec3(0.0);
    modelledTerm = vec3(0.0);
    return light;
}

// A light's own share, as the model returned it.
void noteLight(Surface s, Illumination light) {
    vec3 arrived = light.radiance * modelled;
    lookAt(arrived);
    noteTerm(lightTerm, arrived, dot(s.n, light.l));
    if (shown == SHOWN_LIGHT) {
        litTerm = lightTerm == TERM_LIGHT + shownLight ? vec4(arrived, 1.0) : litTerm;
    } else {
        litTerm = vec4(litTerm.rgb + light.radiance * modelledTerm, HAS_TERMS ? 1.0 : 0.0);
    }
    ++lightTerm;
}
