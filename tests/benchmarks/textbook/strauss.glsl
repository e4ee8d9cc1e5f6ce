// SPDX-License-Identifier: GPL-3.0-or-later
float textbookStraussF(float x, float kf) {
    float limit = 1.0 / (kf * kf);
    return (1.0 / ((x - kf) * (x - kf)) - limit) / (1.0 / ((1.0 - kf) * (1.0 - kf)) - limit);
}

float textbookStraussG(float x, float ks) {
    float limit = 1.0 / ((1.0 - ks) * (1.0 - ks));
    return (limit - 1.0 / ((x - ks) * (x - ks))) / (limit - 1.0 / (ks * ks));
}

float textbookStraussLobe(Strauss p) {
    float a2 = (1.0 - p.smoothness) / (7.0 - p.smoothness);
    float nh = dot(N, normalize(L + V));
    if (p.lobe == STRAUSS_LOBE_BECKMANN) {
        float tangent = tan(acos(nh));
        return exp(-tangent * tangent / a2) / pow(nh, 4.0);
    }
    if (p.lobe == STRAUSS_LOBE_GGX) {
        float below = nh * nh * (a2 - 1.0) + 1.0;
        return a2 * a2 / (below * below);
    }
    return pow(max(dot(reflect(-L, N), V), 0.0), 3.0 / (1.0 - p.smoothness));
}

float textbookStraussArgument(Strauss p, float c) {
    return p.argument == STRAUSS_ARGUMENT_COSINE ? c : acos(c) / (0.5 * PI);
}

vec3 strauss(Directions d, Strauss p) {
    float nl = dot(N, L);
    float xl = textbookStraussArgument(p, nl);
    float xv = textbookStraussArgument(p, dot(N, V));
    float s3 = pow(p.smoothness, 3.0);
    float diffuse = (1.0 - p.metalness * p.smoothness) * (1.0 - s3) * (1.0 - p.transparency) * nl;
    float rn = s3 * (1.0 - p.transparency);
    float F = textbookStraussF(xl, p.kf);
    float j = F * textbookStraussG(xl, p.ks) * textbookStraussG(xv, p.ks);
    float reflected = min(1.0, rn + (rn + p.k) * j);
    vec3 highlight =
        p.specularColor + p.metalness * (1.0 - F) * (p.diffuseColor - p.specularColor);
    highlight *= textbookStraussLobe(p) * reflected;
    highlight = p.glossMode == STRAUSS_GLOSS_MODE_LIMIT ? min(highlight, vec3(p.gloss))
                                                        : p.gloss * highlight;
    return p.diffuseColor * diffuse + highlight;
}
