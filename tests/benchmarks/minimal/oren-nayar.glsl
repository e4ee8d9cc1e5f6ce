// SPDX-License-Identifier: GPL-3.0-or-later
uniform vec3 diffuseColor;
uniform float roughness;

vec3 lit(vec3 n, vec3 v, vec3 l) {
    float nl = dot(n, l);
    float nv = dot(n, v);
    if (nl <= 0.0) {
        return vec3(0.0);
    }
    float sigma2 = roughness * roughness;
    float A = 1.0 - 0.5 * sigma2 / (sigma2 + 0.33);
    float B = 0.45 * sigma2 / (sigma2 + 0.09);
    float azimuth = (dot(l, v) - nl * nv) / max(nl, nv);
    return DIFFUSE_COLOR * (nl * (A + B * max(azimuth, 0.0)));
}
