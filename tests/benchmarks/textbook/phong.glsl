// SPDX-License-Identifier: GPL-3.0-or-later
vec3 phong(Directions d, Phong p) {
    float nl = dot(N, L);
    float lobe = pow(max(dot(reflect(-L, N), V), 0.0), p.shininess);
    if (p.normalisation == PHONG_NORMALISATION_NORMALISED) {
        lobe *= 0.5 * (p.shininess + 2.0) * nl;
    }
    vec3 highlight = p.specularColor * lobe;
    highlight = p.glossMode == PHONG_GLOSS_MODE_LIMIT ? min(highlight, vec3(p.gloss))
                                                      : p.gloss * highlight;
    return p.diffuseColor * nl + highlight;
}
