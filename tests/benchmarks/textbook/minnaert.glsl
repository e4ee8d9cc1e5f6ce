// SPDX-License-Identifier: GPL-3.0-or-later
vec3 minnaert(Directions d, Minnaert p) {
    float nl = dot(N, L);
    float value = nl * pow(nl * dot(N, V), p.darkening - 1.0);
    if (p.normalisation == MINNAERT_NORMALISATION_NORMALISED) {
        value *= 0.5 * (p.darkening + 1.0);
    }
    return p.diffuseColor * value;
}
