// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 diffuseColor;
uniform vec3 specularColor;
uniform float roughness;
uniform float gloss;
uniform vec3 fresnelF0;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    float nv = dot(n, v);
    if (nl <= 0.0) {
        return vec3(0.0);
    }
    vec3 H = l + v;
    float HH = dot(H, H);
    float nH = nl + nv;
    vec3 P = H - nH * n;
    float tan2 = dot(P, P) / (nH * nH);
    float alpha = max(roughness, 1e-4); // the slider goes down to 0
    float alpha2 = alpha * alpha;
    float D = exp2(-1.4426950408889634 * tan2 / alpha2) * (1.0 + tan2) * (1.0 + tan2) / alpha2;
    float V = min(0.25 / nv, nH / HH * min(nl / nv, 1.0));
    vec3 chord = l - v;
    float versine = 0.25 * dot(chord, chord) / (1.0 + 0.5 * sqrt(HH));
    vec3 F = fresnelF0 + (vec3(1.0) - fresnelF0) * pow5(versine);
    return DIFFUSE_COLOR * nl + specularColor * F * (gloss * D * V);
}
