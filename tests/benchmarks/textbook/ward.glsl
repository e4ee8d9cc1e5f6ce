// SPDX-License-Identifier: GPL-3.0-or-later
vec3 ward(Directions d, Ward p) {
    vec3 t = cos(p.tangentAngle) * T + sin(p.tangentAngle) * B;
    vec3 b = cos(p.tangentAngle) * B - sin(p.tangentAngle) * T;
    float nl = dot(N, L);
    vec3 H = L + V;
    vec3 h = normalize(H);
    float theta = acos(dot(N, h));
    float phi = atan(dot(h, b), dot(h, t));
    float x = cos(phi) / p.roughnessX;
    float y = sin(phi) / p.roughnessY;
    float lobe = exp(-tan(theta) * tan(theta) * (x * x + y * y)) / (PI * p.roughnessX * p.roughnessY)
        * dot(H, H) / pow(dot(H, N), 4.0);
    return p.diffuseColor * nl + p.gloss * p.specularColor * (PI * nl * lobe);
}
