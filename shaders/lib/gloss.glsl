// SPDX-License-Identifier: MIT-0
// How much of a highlight a gloss value g = 0 .. 1 leaves.

// g * specular, or, where `limits`, no channel above g times what a white matte surface shows under
// the same light: min(specular, g white). `white` is n.l for a BRDF, which keeps the highlight
// reciprocal and lets it fade at the horizon, and 1 for a lobe that has no n.l of its own, where
// the limit is then the plateau of older game shaders. All >= 0; g = 1 multiplied changes nothing.
vec3 glossed(vec3 specular, float gloss, bool limits, float white) {
    if (limits) {
        return min(specular, vec3(gloss * white));
    }
    return gloss * specular;
}

// The same of a colour and how strong it is, with the products of single numbers first.
vec3 glossedLobe(vec3 color, float lobe, float gloss, bool limits, float white) {
    if (limits) {
        return min(lobe * color, vec3(gloss * white));
    }
    return gloss * lobe * color;
}
