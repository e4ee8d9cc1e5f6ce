// SPDX-License-Identifier: GPL-3.0-or-later
vec3 schlick(Directions d, Schlick p) {
    float t = max(dot(reflect(-L, N), V), 0.0);
    float lobe = t / (p.shininess - p.shininess * t + t);
    return p.diffuseColor * dot(N, L) + p.gloss * p.specularColor * lobe;
}
