// SPDX-License-Identifier: GPL-3.0-or-later
// Three directional lights.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec3 light1Direction;
uniform vec3 light1Color;
uniform float light1Intensity;
uniform vec3 light2Direction;
uniform vec3 light2Color;
uniform float light2Intensity;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction)
        + light1Color * light1Intensity * lit(n, v, -light1Direction)
        + light2Color * light2Intensity * lit(n, v, -light2Direction));
}
