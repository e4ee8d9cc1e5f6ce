// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light on a normal map. From behind its relief is the other way round.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform float imageStrength;
centroid in vec3 worldTangent;
in float surfaceSide;

vec3 mappedNormal(vec3 n, vec3 v) {
    vec3 t = normalize(worldTangent - dot(worldTangent, n) * n);
    vec3 slope = 2.0 * texel().rgb - 1.0;
    vec2 tilt = imageStrength
        * (slope.x * normalize(imageAcross.xy) + slope.y * normalize(imageUp.xy));
    float front = dot(worldNormal, n) < 0.0 ? -1.0 : 1.0;
    return towardsViewer(normalize(front * tilt.x * t + surfaceSide * tilt.y * cross(n, t)
        + max(slope.z, 0.0) * n), v);
}

void main() {
    vec3 v = normalize(toEye);
    vec3 n = mappedNormal(seenNormal(v), v);
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction));
}
