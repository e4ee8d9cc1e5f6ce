// SPDX-License-Identifier: GPL-3.0-or-later
vec3 heidrichSeidel(Directions d, HeidrichSeidel p) {
    vec3 t = cos(p.tangentAngle) * T + sin(p.tangentAngle) * B;
    float lt = dot(L, t);
    float vt = dot(V, t);
    float sl = sqrt(1.0 - lt * lt);
    float lobe = pow(max(sl * sqrt(1.0 - vt * vt) - lt * vt, 0.0), p.shininess);
    return dot(N, L) * (p.diffuseColor * sl + p.gloss * p.specularColor * lobe);
}
