// SPDX-License-Identifier: GPL-3.0-or-later
vec3 blinnPhong(Directions d, BlinnPhong p) {
    float nl = dot(N, L);
    float nh = dot(N, normalize(L + V));
    float lobe = nl > 0.0 && nh > 0.0 ? pow(nh, p.shininess) : 0.0;
    return p.diffuseColor * max(nl, 0.0) + p.gloss * p.specularColor * lobe;
}
