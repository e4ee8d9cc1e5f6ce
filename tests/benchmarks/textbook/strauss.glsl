// SPDX-License-Identifier: GPL-3.0-or-later
float textbookStraussF(float x, float kf) {
    float limit = 1.0 / (kf * kf);
    return (1.0 / ((x - kf) * (x - kf)) - limit) / (1.0 / ((1.0 - kf) * (1.0 - kf)) - limit);
}

float textbookStraussG(float x, float ks) {
    float limit = 1.0 / ((1.0 - ks) * (1.0 - ks));
    return (limit - 1.0 / ((x - ks) * (x - ks))) / (limit - 1.0 / (ks * ks));
}

vec3 strauss(Directions d, Strauss p) {
    float nl = dot(N, L);
    float xl = acos(nl) / (0.5 * PI);
    float xv = acos(dot(N, V)) / (0.5 * PI);
    float s3 = pow(p.smoothness, 3.0);
    float diffuse = (1.0 - p.metalness * p.smoothness) * (1.0 - s3) * (1.0 - p.transparency) * nl;
    float rn = s3 * (1.0 - p.transparency);
    float F = textbookStraussF(xl, p.kf);
    float j = F * textbookStraussG(xl, p.ks) * textbookStraussG(xv, p.ks);
    float reflected = min(1.0, rn + (rn + p.k) * j);
    float lobe = pow(max(dot(reflect(-L, N), V), 0.0), 3.0 / (1.0 - p.smoothness));
    vec3 highlight =
        p.specularColor + p.metalness * (1.0 - F) * (p.diffuseColor - p.specularColor);
    return p.diffuseColor * diffuse + p.gloss * highlight * (lobe * reflected);
}
