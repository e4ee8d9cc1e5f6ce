// SPDX-License-Identifier: MIT-0
// A pane: the ray leaves it in its old direction.

Passage passageFrom(Surface s, Interface c, Refraction p) {
    vec3 inside = refractedRay(c, p);
    Passage w;
    w.way = p.thickness / max(-dot(inside, s.n), 1e-3);
    w.x = s.x + w.way * inside;
    w.leaving = -s.v;
    w.inner = w.leaving;
    w.kept = 0.0;
    return w;
}

vec3 lightThrough(Surface s, Passage w) {
    return seenBehind(s, w, dFdx(w.leaving), dFdy(w.leaving));
}
