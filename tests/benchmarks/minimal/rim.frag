// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light, blended towards a tint at the rim.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec3 fresnelF0;
uniform vec3 fresnelColor;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    vec3 shaded = light0Color * light0Intensity * lit(n, v, -light0Direction);
    vec3 share = fresnelF0 + (vec3(1.0) - fresnelF0) * pow5(1.0 - dot(n, v));
    color = stored(mix(shaded, fresnelColor, share));
}
