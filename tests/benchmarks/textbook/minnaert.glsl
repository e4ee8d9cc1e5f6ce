// SPDX-License-Identifier: GPL-3.0-or-later
vec3 minnaert(Directions d, Minnaert p) {
    float nl = dot(N, L);
    return p.diffuseColor * (nl * pow(nl * dot(N, V), p.darkening - 1.0));
}
