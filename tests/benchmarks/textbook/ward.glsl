// SPDX-License-Identifier: GPL-3.0-or-later
vec3 ward(Directions d, Ward p) {
    float nl = dot(N, L);
    float nv = dot(N, V);
    vec3 H = L + V;
    vec3 h = normalize(H);
    float theta = acos(dot(N, h));
    float ax = p.roughness;
    float ay = p.roughness;
    float slopes = 1.0 / (ax * ax);
    if (p.grain == WARD_GRAIN_ANISOTROPIC) {
        vec3 t = cos(p.tangentAngle) * T + sin(p.tangentAngle) * B;
        vec3 b = cos(p.tangentAngle) * B - sin(p.tangentAngle) * T;
        float phi = atan(dot(h, b), dot(h, t));
        ax = p.roughnessX;
        ay = p.roughnessY;
        slopes = cos(phi) * cos(phi) / (ax * ax) + sin(phi) * sin(phi) / (ay * ay);
    }
    float lobe = exp(-tan(theta) * tan(theta) * slopes) / (4.0 * PI * ax * ay);
    if (p.variant == WARD_VARIANT_1992) {
        lobe /= sqrt(nl * nv);
    } else if (p.variant == WARD_VARIANT_DUER) {
        lobe /= nl * nv;
    } else {
        lobe *= 4.0 * dot(H, H) / pow(dot(H, N), 4.0);
    }
    vec3 highlight = p.specularColor * (PI * nl * lobe);
    highlight = p.glossMode == WARD_GLOSS_MODE_LIMIT ? min(highlight, vec3(p.gloss))
                                                     : p.gloss * highlight;
    return p.diffuseColor * nl + highlight;
}
