// SPDX-License-Identifier: GPL-3.0-or-later
// A point light and the sun.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec3 light1Position;
uniform vec3 light1Color;
uniform float light1Intensity;
uniform float light1AttenuationConstant;
uniform float light1AttenuationLinear;
uniform float light1AttenuationQuadratic;

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    vec3 way = light1Position - worldPosition;
    float range = length(way);
    float fall = light1AttenuationConstant
        + range * (light1AttenuationLinear + range * light1AttenuationQuadratic);
    color = stored(light0Color * light0Intensity * lit(n, v, -light0Direction)
        + light1Color * (light1Intensity / fall) * lit(n, v, way / range));
}
