// SPDX-License-Identifier: MIT-0
// The map of a light with a place: one window, or six around it.

// The way to x, seen from the light, in the axes of the face that it meets: right, up, forward.
vec3 shadowFaceWay(ShadowView view, vec3 x, OUT(float) face) {
    vec3 d = vec3(dot(x, view.right), dot(x, view.up), dot(x, view.forward));
    vec3 size = abs(d);
    face = 0.0;
    if (view.faces < 2.0 || (size.z >= size.x && size.z >= size.y)) {
        bool behind = view.faces > 2.0 && d.z < 0.0;
        face = behind ? 1.0 : 0.0;
        return behind ? vec3(-d.x, d.y, -d.z) : d;
    }
    if (size.x >= size.y) {
        face = d.x > 0.0 ? 2.0 : 3.0;
        return d.x > 0.0 ? vec3(-d.z, d.y, d.x) : vec3(d.z, d.y, -d.x);
    }
    face = d.y > 0.0 ? 4.0 : 5.0;
    return d.y > 0.0 ? vec3(d.x, -d.z, d.y) : vec3(d.x, d.z, -d.y);
}

// Metres as a perspective stores them, not below the nearest.
float localShadowStored(ShadowView view, float depth) {
    float inside = max(depth, view.near);
    return view.far * (inside - view.near) / (inside * (view.far - view.near));
}

// From the light through the point `offset` metres beside s.x, at right angles to its way there.
ShadowRay localShadowRay(ShadowPoint s, vec2 offset) {
    vec3 way = s.x - s.view.origin;
    vec3 x = way + offset.x * s.across + offset.y * s.along;
    float plane = min(dot(way, s.n), -1e-9);
    float reach = plane / min(dot(x, s.n), 0.25 * plane);
    float face;
    vec3 q = shadowFaceWay(s.view, x, face);
    float forward = max(q.z, 1e-9);
    ShadowRay ray;
    ray.place = vec3(q.xy / forward * s.view.window.xy + s.view.window.zw, s.view.layer + face);
    ray.place.x = q.z > 0.0 ? ray.place.x : -1.0;
    float depth = forward * reach;
    ray.depth = depth - 1e-6 * depth * (1.0 + depth / s.view.near);
    ray.stretch = length(x) / forward;
    ray.doubt = s.rise * length(offset);
    ray.stored = localShadowStored(s.view, ray.depth - ray.doubt);
    return ray;
}

// Stored depths of a perspective as metres; where nothing is, very far.
vec4 localShadowDepths(ShadowPoint s, vec4 stored) {
    return s.view.near * s.view.far / (s.view.far - stored * (s.view.far - s.view.near)) +
        1e30 * step(vec4(1.0), stored);
}
