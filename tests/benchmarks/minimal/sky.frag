// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light, a sky and a ground. Of these the model gives back what it shows of light
// along the normal from 60 degrees.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec3 skyColor;
uniform vec3 groundColor;
uniform vec3 skyUp;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    vec3 around = mix(groundColor, skyColor, 0.5 + 0.5 * dot(n, skyUp));
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction)
        + around * lit(vec3(0.0, 0.0, 1.0), vec3(0.8660254, 0.0, 0.5), vec3(0.0, 0.0, 1.0)));
}
