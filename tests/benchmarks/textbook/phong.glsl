// SPDX-License-Identifier: GPL-3.0-or-later
vec3 phong(Directions d, Phong p) {
    vec3 r = reflect(-L, N);
    float lobe = pow(max(dot(r, V), 0.0), p.shininess);
    return p.diffuseColor * dot(N, L) + p.gloss * p.specularColor * lobe;
}
