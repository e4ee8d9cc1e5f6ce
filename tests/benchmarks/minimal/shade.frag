// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light with a depth map. The point is moved along the normal by what the map can
// be wrong about it: more, the flatter the light comes in.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec4 shadowAcross; // the rows that take (x, 1) to the place and the depth in the map
uniform vec4 shadowUp;
uniform vec4 shadowDepth;
uniform float shadowTexel;
uniform sampler2DArray shadowMaps;

float arriving(vec3 n, vec3 l) {
    float nl = dot(n, l);
    vec4 x = vec4(worldPosition
        + n * (shadowTexel * (0.25 + 1.5 * sqrt(max(1.0 - nl * nl, 0.0)))), 1.0);
    vec2 place = vec2(dot(x, shadowAcross), dot(x, shadowUp));
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)))) {
        return 1.0;
    }
    vec2 size = vec2(textureSize(shadowMaps, 0).xy);
    vec2 corner = floor(place * size - 0.5) + 1.0;
    vec2 f = fract(place * size - 0.5);
    vec4 depths = textureGather(shadowMaps, vec3(corner / size, 0.0));
    vec4 passes = step(vec4(min(dot(x, shadowDepth), 1.0)), depths);
    return mix(mix(passes.w, passes.z, f.x), mix(passes.x, passes.y, f.x), f.y);
}

void main() {
    vec3 v = normalize(toEye);
    vec3 n = seenNormal(v);
    vec3 l = -light0Direction;
    color = stored(light0Color * light0Intensity * arriving(n, l) * lit(n, v, l));
}
