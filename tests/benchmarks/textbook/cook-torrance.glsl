// SPDX-License-Identifier: GPL-3.0-or-later
float textbookD(CookTorrance p, float nh) {
    float m = p.roughness;
    float alpha = acos(nh);
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_GGX) {
        float below = nh * nh * (m * m - 1.0) + 1.0;
        return m * m / (PI * below * below);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_TROWBRIDGE_REITZ) {
        float b2 = cos(m) * cos(m);
        float c2 = (b2 - 1.0) / (b2 - sqrt(2.0));
        float below = nh * nh * (c2 - 1.0) + 1.0;
        return c2 / (PI * below * below);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_TORRANCE_SPARROW) {
        float c = sqrt(log(2.0)) / m;
        return exp(-c * c * alpha * alpha) * c * c / PI;
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_PHONG) {
        float c = -log(2.0) / log(cos(m));
        return pow(nh, c) * (c + 2.0) / (2.0 * PI);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_BLINN_GAUSSIAN) {
        return p.gaussianConstant * exp(-(alpha / m) * (alpha / m)) / (PI * m * m);
    }
    float tangent = tan(alpha) / m;
    return exp(-tangent * tangent) / (PI * m * m * pow(nh, 4.0));
}

// Abramowitz and Stegun 1964, 7.1.26.
float textbookErf(float x) {
    float t = 1.0 / (1.0 + 0.3275911 * x);
    return 1.0 - t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027
        + t * 1.061405429)))) * exp(-x * x);
}

float textbookLambda(CookTorrance p, float c) {
    float t = tan(acos(c));
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_GGX
        || p.distribution == COOK_TORRANCE_DISTRIBUTION_TROWBRIDGE_REITZ) {
        return 0.5 * (sqrt(1.0 + p.roughness * p.roughness * t * t) - 1.0);
    }
    float a = 1.0 / (p.roughness * t);
    return 0.5 * (textbookErf(a) - 1.0 + exp(-a * a) / (a * sqrt(PI)));
}

float textbookG(CookTorrance p, float nl, float nv, float nh, float vh) {
    if (p.masking == COOK_TORRANCE_MASKING_SMITH) {
        return 1.0 / ((1.0 + textbookLambda(p, nl)) * (1.0 + textbookLambda(p, nv)));
    }
    if (p.masking == COOK_TORRANCE_MASKING_SMITH_CORRELATED) {
        return 1.0 / (1.0 + textbookLambda(p, nl) + textbookLambda(p, nv));
    }
    if (p.masking == COOK_TORRANCE_MASKING_SCHLICK_SMITH) {
        float k = p.roughness * sqrt(2.0 / PI);
        return nl / (nl * (1.0 - k) + k) * (nv / (nv * (1.0 - k) + k));
    }
    return min(1.0, min(2.0 * nh * nv / vh, 2.0 * nh * nl / vh));
}

vec3 cookTorrance(Directions d, CookTorrance p) {
    vec3 H = normalize(L + V);
    float nl = dot(N, L);
    float nv = dot(N, V);
    float nh = dot(N, H);
    float vh = dot(V, H);
    float c = vh;
    if (p.fresnelCosine == COOK_TORRANCE_FRESNEL_COSINE_LIGHT) {
        c = nl;
    }
    if (p.fresnelCosine == COOK_TORRANCE_FRESNEL_COSINE_VIEW) {
        c = nv;
    }
    vec3 f0 = p.fresnel.f0;
    vec3 F = f0 + (vec3(1.0) - f0) * pow(1.0 - c, 5.0);
    float scale = p.scale == COOK_TORRANCE_SCALE_1982 ? PI : 0.25;
    float lobe = textbookD(p, nh) * textbookG(p, nl, nv, nh, vh) / (nl * nv);
    vec3 highlight = p.specularColor * F * (PI * scale * lobe * nl);
    highlight = p.glossMode == COOK_TORRANCE_GLOSS_MODE_LIMIT ? min(highlight, vec3(p.gloss))
                                                              : p.gloss * highlight;
    float diffuseShare = 1.0;
    if (p.balance == COOK_TORRANCE_BALANCE_SPLIT) {
        diffuseShare -= p.specularShare;
        highlight *= p.specularShare;
    }
    return p.diffuseColor * (diffuseShare * nl) + highlight;
}
