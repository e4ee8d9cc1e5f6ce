// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light in fog.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec3 fogColor;
uniform float fogDensity;

void main() {
    float range = length(toEye);
    vec3 v = toEye / range;
    vec3 n = seenNormal(v);
    vec3 shaded = light0Color * light0Intensity * lit(n, v, -light0Direction);
    color = stored(mix(fogColor, shaded, exp(-fogDensity * range)));
}
