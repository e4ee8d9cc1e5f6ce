// SPDX-License-Identifier: GPL-3.0-or-later
vec3 lommelSeeliger(Directions d, LommelSeeliger p) {
    float nl = dot(N, L);
    return p.diffuseColor * (nl / (nl + dot(N, V)));
}
