// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction));
}
