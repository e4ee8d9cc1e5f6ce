// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light; the surface is transparent.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform float opacity;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    color = vec4(stored(light0Color * light0Intensity * lit(n, v, -light0Direction)).rgb, opacity);
}
