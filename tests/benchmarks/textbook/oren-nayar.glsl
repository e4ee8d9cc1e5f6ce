// SPDX-License-Identifier: GPL-3.0-or-later
float textbookEonE(float mu, float r) {
    float si = sqrt(1.0 - mu * mu);
    float G = si * (acos(mu) - si * mu)
        + 2.0 / 3.0 * ((si / mu) * (1.0 - pow(si, 3.0)) - si);
    float A = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * r);
    return A + r / PI * A * G;
}

vec3 textbookEon(OrenNayar p, float nl, float nv, float lv) {
    float r = p.roughness;
    float s = lv - nl * nv;
    float A = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * r);
    vec3 single = p.diffuseColor * (nl * A * (1.0 + r * (s > 0.0 ? s / max(nl, nv) : s)));
    if (p.form == OREN_NAYAR_FORM_FUJII) {
        return single;
    }
    float average = A * (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * PI)) * r);
    vec3 rho = p.diffuseColor * p.diffuseColor * average
        / (vec3(1.0) - p.diffuseColor * max(0.0, 1.0 - average));
    float loss = max(1e-7, 1.0 - textbookEonE(nl, r)) * max(1e-7, 1.0 - textbookEonE(nv, r));
    return single + rho * (nl * loss / max(1e-7, 1.0 - average));
}

vec3 textbookFull(OrenNayar p, float nl, float cosPhi, float a, float b) {
    float s2 = p.roughness * p.roughness;
    float spread = s2 / (s2 + 0.09);
    float C1 = 1.0 - 0.5 * s2 / (s2 + 0.33);
    float C2 = 0.45 * spread
        * (cosPhi >= 0.0 ? sin(a) : sin(a) - pow(2.0 * b / PI, 3.0));
    float C3 = 0.125 * spread * pow(4.0 * a * b / (PI * PI), 2.0);
    float direct =
        C1 + cosPhi * C2 * tan(b) + (1.0 - abs(cosPhi)) * C3 * tan(0.5 * (a + b));
    vec3 value = p.diffuseColor * direct;
    if (p.form == OREN_NAYAR_FORM_INTERREFLECTION) {
        value += 0.17 * p.diffuseColor * p.diffuseColor * (s2 / (s2 + 0.13))
            * (1.0 - cosPhi * pow(2.0 * b / PI, 2.0));
    }
    return value * nl;
}

vec3 orenNayar(Directions d, OrenNayar p) {
    float nl = dot(N, L);
    float nv = dot(N, V);
    if (p.form == OREN_NAYAR_FORM_FUJII || p.form == OREN_NAYAR_FORM_EON) {
        return textbookEon(p, nl, nv, dot(L, V));
    }
    float thetaL = acos(nl);
    float thetaV = acos(nv);
    float cosPhi = dot(normalize(L - N * nl), normalize(V - N * nv));
    float a = max(thetaL, thetaV);
    float b = min(thetaL, thetaV);
    if (p.form == OREN_NAYAR_FORM_FULL || p.form == OREN_NAYAR_FORM_INTERREFLECTION) {
        return textbookFull(p, nl, cosPhi, a, b);
    }
    float s2 = p.roughness * p.roughness;
    float A = 1.0 - 0.5 * s2 / (s2 + (p.form == OREN_NAYAR_FORM_QUALITATIVE_057 ? 0.57 : 0.33));
    float B = 0.45 * s2 / (s2 + 0.09);
    return p.diffuseColor * (nl * (A + B * max(cosPhi, 0.0) * sin(a) * tan(b)));
}
