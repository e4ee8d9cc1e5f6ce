// SPDX-License-Identifier: MIT-0
// The map of a light from very far away.

// Through the point `offset` metres beside s.x, at right angles to the light's way. Written so that
// what does not depend on the offset is worked out once.
ShadowRay parallelShadowRay(ShadowPoint s, vec2 offset) {
    vec3 x = s.x - s.view.origin;
    vec2 beside = vec2(dot(x, s.across), dot(x, s.along)) + offset;
    vec2 rise = vec2(dot(s.across, s.n), dot(s.along, s.n)) / dot(s.l, s.n);
    ShadowRay ray;
    ray.place = vec3(beside * s.view.window.xy + s.view.window.zw, s.view.layer);
    ray.depth = dot(x, s.view.forward) + dot(offset, rise);
    ray.stretch = 1.0;
    ray.doubt = shadowedRise(s, offset) +
        1e-6 * (abs(ray.depth) + s.view.far - s.view.near);
    return ray;
}

// Stored depths as metres; where nothing is, very far.
vec4 parallelShadowDepths(ShadowPoint s, vec4 stored) {
    return s.view.near + stored * (s.view.far - s.view.near) + 1e30 * step(vec4(1.0), stored);
}
