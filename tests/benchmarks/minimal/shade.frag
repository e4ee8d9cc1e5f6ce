// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light with a depth map. The point is moved along the normal by what the map can
// be wrong about it: more, the flatter the light comes in.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec3 shadowRight;
uniform vec3 shadowUp;
uniform vec3 shadowForward;
uniform vec3 shadowOrigin;
uniform vec4 shadowWindow;
uniform float shadowNear;
uniform float shadowFar;
uniform float shadowTexel;
uniform sampler2DArray shadowMaps;

float arriving(vec3 n, vec3 l) {
    float nl = dot(n, l);
    vec3 x = worldPosition - shadowOrigin
        + n * (shadowTexel * (0.25 + 1.5 * sqrt(max(1.0 - nl * nl, 0.0))));
    vec2 place = vec2(dot(x, shadowRight), dot(x, shadowUp)) * shadowWindow.xy + shadowWindow.zw;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)))) {
        return 1.0;
    }
    vec2 size = vec2(textureSize(shadowMaps, 0).xy);
    vec2 corner = floor(place * size - 0.5) + 1.0;
    vec2 f = fract(place * size - 0.5);
    vec4 depths = textureGather(shadowMaps, vec3(corner / size, 0.0));
    float depth = (dot(x, shadowForward) - shadowNear) / (shadowFar - shadowNear);
    vec4 passes = max(step(vec4(depth), depths), step(vec4(1.0), depths));
    return mix(mix(passes.w, passes.z, f.x), mix(passes.x, passes.y, f.x), f.y);
}

void main() {
    vec3 v = normalize(eye - worldPosition);
    vec3 n = seenNormal(v);
    vec3 l = -light0Direction;
    color = stored(light0Color * light0Intensity * arriving(n, l) * lit(n, v, l));
}
