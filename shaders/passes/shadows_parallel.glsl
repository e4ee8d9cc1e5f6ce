// SPDX-License-Identifier: MIT-0
// The map of a light from very far away.

// Through the point `offset` metres beside s.x, at right angles to the light's way. Written so that
// what does not depend on the offset is worked out once, and so that drivers see what is 0 without
// one: they do for a product, not for a quotient.
ShadowRay parallelShadowRay(ShadowPoint s, vec2 offset) {
    vec3 x = s.x - s.view.origin;
    vec3 seen = vec3(dot(x, s.view.right), dot(x, s.view.up), dot(x, s.view.forward));
    float higher = dot(offset, vec2(dot(s.across, s.n), dot(s.along, s.n))) *
        (1.0 / dot(s.l, s.n));
    float span = s.view.far - s.view.near;
    ShadowRay ray;
    ray.place = vec3(seen.xy + offset * (1.0 / s.view.window.x), s.view.layer);
    ray.stretch = 1.0;
    ray.doubt = s.rise * length(offset);
    ray.depth = s.view.near + seen.z * span + higher;
    ray.stored = seen.z + (higher - ray.doubt) * (1.0 / span);
    return ray;
}

// Stored depths as metres; where nothing is, very far.
vec4 parallelShadowDepths(ShadowPoint s, vec4 stored) {
    return s.view.near + stored * (s.view.far - s.view.near) + 1e30 * step(vec4(1.0), stored);
}
