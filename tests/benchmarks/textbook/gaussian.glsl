// SPDX-License-Identifier: GPL-3.0-or-later
vec3 gaussian(Directions d, Gaussian p) {
    float angle = acos(dot(N, normalize(L + V)));
    float x = angle / p.width;
    return p.diffuseColor * dot(N, L) + p.gloss * p.specularColor * exp(-x * x);
}
