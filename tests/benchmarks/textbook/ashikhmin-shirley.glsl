// SPDX-License-Identifier: GPL-3.0-or-later
vec3 ashikhminShirley(Directions d, AshikhminShirley p) {
    vec3 t = cos(p.tangentAngle) * T + sin(p.tangentAngle) * B;
    vec3 b = cos(p.tangentAngle) * B - sin(p.tangentAngle) * T;
    vec3 h = normalize(L + V);
    float nl = dot(N, L);
    float nv = dot(N, V);
    float nh = dot(N, h);
    float vh = dot(V, h);
    float ht = dot(h, t);
    float hb = dot(h, b);
    float e = (p.shininessX * ht * ht + p.shininessY * hb * hb) / (1.0 - nh * nh);
    vec3 f0 = p.fresnel.f0;
    vec3 F = f0 + (vec3(1.0) - f0) * pow(1.0 - vh, 5.0);
    float lobe = sqrt((p.shininessX + 1.0) * (p.shininessY + 1.0)) / (8.0 * PI)
        * pow(nh, e) / (vh * max(nl, nv));
    if (p.diffuseKind == ASHIKHMIN_SHIRLEY_DIFFUSE_KIND_LAMBERT) {
        return p.diffuseColor * nl + p.gloss * p.specularColor * F * (PI * nl * lobe);
    }
    vec3 diffuse = 28.0 / (23.0 * PI) * p.diffuseColor * (vec3(1.0) - p.specularColor * f0)
        * (1.0 - pow(1.0 - 0.5 * nl, 5.0)) * (1.0 - pow(1.0 - 0.5 * nv, 5.0));
    return PI * nl * (diffuse + p.gloss * p.specularColor * F * lobe);
}
