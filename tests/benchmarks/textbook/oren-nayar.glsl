// SPDX-License-Identifier: GPL-3.0-or-later
vec3 orenNayar(Directions d, OrenNayar p) {
    float nl = dot(N, L);
    float nv = dot(N, V);
    float thetaL = acos(nl);
    float thetaV = acos(nv);
    float cosPhi = dot(normalize(L - N * nl), normalize(V - N * nv));
    float a = max(thetaL, thetaV);
    float b = min(thetaL, thetaV);
    float s2 = p.roughness * p.roughness;
    float A = 1.0 - 0.5 * s2 / (s2 + 0.33);
    float B = 0.45 * s2 / (s2 + 0.09);
    return p.diffuseColor * (nl * (A + B * max(cosPhi, 0.0) * sin(a) * tan(b)));
}
