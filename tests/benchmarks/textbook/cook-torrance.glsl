// SPDX-License-Identifier: GPL-3.0-or-later
vec3 cookTorrance(Directions d, CookTorrance p) {
    vec3 H = normalize(L + V);
    float nl = dot(N, L);
    float nv = dot(N, V);
    float nh = dot(N, H);
    float vh = dot(V, H);
    float m = p.roughness;
    float alpha = acos(nh);
    float tangent = tan(alpha) / m;
    float D = exp(-tangent * tangent) / (PI * m * m * pow(nh, 4.0));
    float G = min(1.0, min(2.0 * nh * nv / vh, 2.0 * nh * nl / vh));
    vec3 f0 = p.fresnel.f0;
    vec3 F = f0 + (vec3(1.0) - f0) * pow(1.0 - vh, 5.0);
    vec3 highlight = F * (PI * D * G / (4.0 * nl * nv) * nl);
    return p.diffuseColor * nl + p.gloss * p.specularColor * highlight;
}
