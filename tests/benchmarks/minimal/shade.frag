// SPDX-License-Identifier: GPL-3.0-or-later
// One directional light with a depth map. The point is moved along the normal by what the map can
// be wrong about it: more, the flatter the light comes in on the triangle, which is what the map
// holds (by the mesh's normal alone the triangles of a coarse ball shade themselves). The inside
// of a body is looked up farther in, too, or light shines through its edges.
uniform vec3 light0Direction;
uniform vec3 light0Color;
uniform float light0Intensity;
uniform vec4 shadowAcross; // the rows that take (x, 1) to the place and the depth in the map
uniform vec4 shadowUp;
uniform vec4 shadowDepth;
uniform float shadowTexel;
uniform sampler2DArray shadowMaps;

float arriving(vec3 n, vec3 v, vec3 l) {
    vec3 dx = dFdx(toEye);
    vec3 dy = dFdy(toEye);
    vec3 face = cross(dx, dy) / dot(toEye, toEye);
    face *= (dot(face, v) < 0.0 ? -1.0 : 1.0) * inversesqrt(max(dot(face, face), 1e-30));
    float nl = dot(face, l);
    float slant = sqrt(max(1.0 - nl * nl, 0.0));
    vec3 at = worldPosition + n * (shadowTexel * (0.25 + 1.5 * slant));
    if (dot(worldNormal, n) < 0.0) {
        float pixel = sqrt(2.0 * (dot(dx, dx) + dot(dy, dy)));
        float inset = 2.0 * shadowTexel + min(pixel, 8.0 * shadowTexel);
        at += (face - nl * l) * (inset / max(slant, 0.01));
    }
    vec4 x = vec4(at, 1.0);
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
    color = stored(light0Color * light0Intensity * arriving(n, v, l) * lit(n, v, l));
}
