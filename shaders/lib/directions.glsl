// SPDX-License-Identifier: MIT-0
// The geometry of one light and one viewer at one point, computed so that nothing cancels.
#include "lib/incidence.glsl"
#include "lib/math.glsl"

// Projections of l (to the light), v (to the viewer) and h (their half vector) on each other, on
// the normal n and on the tangents t and b. All unit, all away from the surface. r is l mirrored
// at n. A model reads what it needs; the compiler drops the rest.
struct Directions {
    float nl; // cosines; negative below the horizon
    float nv;
    float nh;
    float lh; // = h.v
    float lv;
    float rv;
    float lt; // components in the tangent plane
    float lb;
    float vt;
    float vb;
    float ht;
    float hb;
    float sin2h; // sin^2 : cos^2 of the angle between n and h, on the common scale HH;
    float cos2h; // use their ratio, never either alone
    float HH;    // |l + v|^2 = 4 (l.h)^2
    float nH;    // n.(l + v) = n.l + n.v
    float versineLh; // 1 - l.h
    float versineRv; // 1 - r.v
    float sin2l; // sin^2 of the angles of l and v with n
    float sin2v;
    float tH;    // t.(l + v) and b.(l + v), which keep their digits where l and v oppose
    float bH;
    float versineL; // 1 - n.l
    float vercosineL; // 1 + n.l
    vec2 pixel; // where on the picture, in its pixels, for models that draw marks; 0 without one
};

// Squared length of the part of u that is perpendicular to the unit vector n, given nu = n.u.
float perpendicular2(vec3 u, vec3 n, float nu) {
    vec3 p = u - nu * n;
    return dot(p, p);
}

// The geometry for unit n, t, b (orthogonal), l and v. With H = l + v, which is never normalised:
//   tan^2 theta_h = |H - (n.H) n|^2 : (n.H)^2      1 - l.h = |l - v|^2 / 4 / (1 + l.h)
//   1 - n.l = |n - l|^2 / 2                        1 + n.l = |n + l|^2 / 2
//   1 - r.v = |2 (n.l) n - H|^2 / 2                l.h = |H| / 2
//   r.v = (2 (n.l) n - l).v far from the mirror direction, where it is the small one
// so small angles keep all their digits: 1 - cos is never formed from a rounded cosine.
// l = -v has no half vector; h then counts as lying in the surface (nh = ht = hb = 0,
// sin2h : cos2h = 1 : 0), which is where every lobe ends. Directions below the horizon are not
// special here: their cosines are negative, and the engine's gates leave them out.
Directions directions(vec3 n, vec3 t, vec3 b, vec3 l, vec3 v) {
    Directions d;
    d.pixel = vec2(0.0);
    d.nl = dot(n, l);
    d.nv = dot(n, v);
    d.lv = dot(l, v);
    d.lt = dot(l, t);
    d.lb = dot(l, b);
    d.vt = dot(v, t);
    d.vb = dot(v, b);
    d.sin2l = perpendicular2(l, n, d.nl);
    d.sin2v = perpendicular2(v, n, d.nv);

    // 1e-30 is what GPUs that flush subnormals can still divide by; |H| = 1e-15 is far below the
    // rounding of two unit vectors.
    vec3 H = l + v;
    d.HH = dot(H, H);
    bool opposite = !(d.HH > 1e-30);
    d.nH = d.nl + d.nv;
    vec3 P = H - d.nH * n;
    d.sin2h = opposite ? 1.0 : dot(P, P);
    d.tH = dot(P, t);
    d.bH = dot(P, b);
    d.cos2h = d.nH * d.nH;
    float size = sqrt(d.HH);
    d.lh = 0.5 * size;

    vec3 rise = n - l;
    d.versineL = 0.5 * dot(rise, rise);
    vec3 fall = n + l;
    d.vercosineL = 0.5 * dot(fall, fall);
    vec3 chord = l - v;
    d.versineLh = 0.25 * dot(chord, chord) / (1.0 + d.lh);
    // r - v: near the mirror direction they have the same digits, and l + v would round first.
    vec3 r = 2.0 * d.nl * n - l;
    vec3 q = r - v;
    d.versineRv = 0.5 * dot(q, q);
    d.rv = d.versineRv < 0.5 ? 1.0 - d.versineRv : dot(r, v);

    float scale = opposite ? 0.0 : 1.0 / size;
    d.nh = d.nH * scale;
    d.ht = d.tH * scale;
    d.hb = d.bH * scale;
    return d;
}

// The incidence of the light on a facet that mirrors it to the viewer (l.h).
Incidence halfIncidence(Directions d) {
    Incidence i;
    i.c = min(d.lh, 1.0);
    i.versine = min(d.versineLh, 1.0);
    return i;
}

// 1 - n.h = sin^2 / (1 + n.h) where nH > 0, with one division, for the only root is that of l.h.
float upperVersine(Directions d) {
    return d.sin2h / (d.HH + 2.0 * d.nH * d.lh);
}

// The same; 1 where the half vector is below the horizon.
float halfVersine(Directions d) {
    return d.nH > 0.0 ? upperVersine(d) : 1.0;
}

// A unit vector perpendicular to the unit vector n that changes smoothly with n but at n.z = 0:
// the branch keeps the division away from 0. Duff et al., Building an Orthonormal Basis,
// Revisited, JCGT 6(1), 2017, listing 3.
vec3 anyTangent(vec3 n) {
    float s = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + n.z);
    return vec3(1.0 + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// The unit tangent along t, perpendicular to the unit normal n: t - (t.n) n. Where t is zero or
// within 1e-6 rad of n it says nothing about a direction in the surface and any tangent serves.
vec3 tangentAlong(vec3 n, vec3 t) {
    vec3 u = safeNormalize(t, n);
    vec3 p = u - dot(u, n) * n;
    if (!(dot(p, p) > 1e-12)) {
        return anyTangent(n);
    }
    // The second pass removes what the first rounding left along n.
    vec3 w = p / sqrt(dot(p, p));
    vec3 w2 = w - dot(w, n) * n;
    return w2 / sqrt(dot(w2, w2));
}
