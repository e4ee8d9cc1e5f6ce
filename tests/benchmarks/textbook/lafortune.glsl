// SPDX-License-Identifier: GPL-3.0-or-later
vec3 lafortune(Directions d, Lafortune p) {
    vec3 t = cos(p.tangentAngle) * T + sin(p.tangentAngle) * B;
    vec3 b = cos(p.tangentAngle) * B - sin(p.tangentAngle) * T;
    float nl = dot(N, L);
    vec3 base = p.lobe1X * dot(L, t) * dot(V, t) + p.lobe1Y * dot(L, b) * dot(V, b)
        + p.lobe1Z * nl * dot(N, V);
    vec3 lobe = pow(max(base, vec3(0.0)), p.lobe1Exponent);
    lobe *= (p.lobe1Exponent + vec3(2.0)) / 2.0;
    return nl * (p.diffuseColor + p.gloss * p.lobe1Color * lobe);
}
