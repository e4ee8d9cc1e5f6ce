// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light; an image says where the surface is.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform float imageStrength;
uniform float imageThreshold;

void main() {
    if (mix(1.0, texel().a, imageStrength) < imageThreshold) {
        discard;
    }
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction));
}
