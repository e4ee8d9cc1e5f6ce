// SPDX-License-Identifier: GPL-3.0-or-later
vec3 lambert(Directions d, Lambert p) {
    return p.diffuseColor * dot(N, L);
}
