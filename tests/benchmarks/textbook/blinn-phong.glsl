// SPDX-License-Identifier: GPL-3.0-or-later
vec3 blinnPhong(Directions d, BlinnPhong p) {
    float nl = dot(N, L);
    float nh = dot(N, normalize(L + V));
    float lobe = pow(max(nh, 0.0), p.shininess);
    if (p.gating == BLINN_PHONG_GATING_LIT && nl < 0.0) {
        lobe = 0.0;
    }
    if (p.normalisation == BLINN_PHONG_NORMALISATION_NORMALISED) {
        float e = p.shininess;
        lobe *= (e + 2.0) * (e + 4.0) / (8.0 * (pow(2.0, -0.5 * e) + e)) * max(nl, 0.0);
    }
    vec3 highlight = p.specularColor * lobe;
    highlight = p.glossMode == BLINN_PHONG_GLOSS_MODE_LIMIT ? min(highlight, vec3(p.gloss))
                                                            : p.gloss * highlight;
    return p.diffuseColor * max(nl, 0.0) + highlight;
}
