// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light; an image is the diffuse colour.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform float imageStrength;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    imagedColor = mix(diffuseColor, texel().rgb, imageStrength);
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction));
}
