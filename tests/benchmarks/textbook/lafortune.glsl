// SPDX-License-Identifier: GPL-3.0-or-later
vec3 textbookLobe(Lafortune p, vec3 x, vec3 y, vec3 z, vec3 e) {
    vec3 t = cos(p.tangentAngle) * T + sin(p.tangentAngle) * B;
    vec3 b = cos(p.tangentAngle) * B - sin(p.tangentAngle) * T;
    vec3 base = x * dot(L, t) * dot(V, t) + y * dot(L, b) * dot(V, b) + z * dot(N, L) * dot(N, V);
    vec3 lobe = pow(max(base, vec3(0.0)), e);
    return p.normalisation == LAFORTUNE_NORMALISATION_NORMALISED ? lobe * (e + vec3(2.0)) / 2.0
                                                                 : PI * lobe;
}

vec3 lafortune(Directions d, Lafortune p) {
    vec3 lobes =
        p.lobe1Color * textbookLobe(p, p.lobe1X, p.lobe1Y, p.lobe1Z, p.lobe1Exponent);
    if (p.lobes != LAFORTUNE_LOBES_ONE) {
        lobes += p.lobe2Color * textbookLobe(p, p.lobe2X, p.lobe2Y, p.lobe2Z, p.lobe2Exponent);
    }
    if (p.lobes == LAFORTUNE_LOBES_THREE) {
        lobes += p.lobe3Color * textbookLobe(p, p.lobe3X, p.lobe3Y, p.lobe3Z, p.lobe3Exponent);
    }
    lobes = p.glossMode == LAFORTUNE_GLOSS_MODE_LIMIT ? min(lobes, vec3(p.gloss))
                                                      : p.gloss * lobes;
    return dot(N, L) * (p.diffuseColor + lobes);
}
