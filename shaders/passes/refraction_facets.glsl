// SPDX-License-Identifier: MIT-0
// A convex body of flat facets: a ray is followed from facet to facet and splits at each, as its
// planes say. Each round of samples has a ray, through a place of its own within the pixel.

const int MAX_FACETS = 128;

// The outward unit normals, and these times a place of the plane seen from the middle of the body.
uniform vec4 refractionFacets[MAX_FACETS];
uniform int refractionFacetCount; // 0: the body is no such one

// A software driver may end a program after 65536 rounds of its loops. Four facets a round leave 64
// rays of three colours and nine ways inside enough of them.
const int FACETS_AT_ONCE = 4;

// How far it is from m, seen from the middle of the body, along d to the nearest facet in front;
// `n` becomes its normal. Behind the last facet there are zeros.
float wayToFacet(vec3 m, vec3 d, OUT(vec3) n) {
    float way = 2.0 * refractionBody.w;
    n = d;
    for (int first = 0; first < refractionFacetCount; first += FACETS_AT_ONCE) {
        for (int i = 0; i < FACETS_AT_ONCE; ++i) {
            vec4 facet = refractionFacets[first + i];
            float along = dot(facet.xyz, d);
            float left = facet.w - dot(facet.xyz, m);
            if (along > 1e-6 && left < way * along) {
                way = left / along;
                n = facet.xyz;
            }
        }
    }
    return max(way, 0.0);
}

// A share of light that is not followed any farther, but counted as after the last reflection.
const float FAINT = 0.004;

// What a ray sees that goes on in the unit direction d behind the point x within the surface. What
// is still inside after the last reflection counts as what it would see straight ahead.
vec3 lightOfFacets(vec3 x, vec3 d, int channel, Refraction p) {
    vec3 m = x - refractionBody.xyz;
    vec3 sum = vec3(0.0);
    float share = 1.0;
    float way = 0.0;
    for (int i = 0; i <= INNER_REFLECTIONS && share > 0.0; ++i) {
        Interface c;
        float next = wayToFacet(m, d, c.n);
        m += next * d;
        way += next;
        c.l = -d;
        c.n = -c.n;
        c.channel = channel;
        c.leaves = true;
        float kept = mirroredShare(c, p);
        vec3 inner = safeNormalize(d - 2.0 * dot(d, c.n) * c.n, d);
        vec3 leaving = safeNormalize(refractedRay(c, p), inner);
        vec3 left = leftShare(way, p);
        if (kept < 1.0) {
            vec3 seen = lightLeaving(m + refractionBody.xyz, leaving, i);
            sum += share * (1.0 - kept) * left * seen;
        }
        share *= kept;
        d = inner;
        if (i == INNER_REFLECTIONS || share < FAINT) {
            sum += share * left * lightFar(d);
            share = 0.0;
        }
    }
    return sum;
}

vec3 shownTo(Surface s, Refraction p) {
    vec3 mirrored = lightFar(2.0 * dot(s.n, s.v) * s.n - s.v);
    vec3 sum = vec3(0.0);
    for (int channel = FIRST_CHANNEL; channel <= LAST_CHANNEL; ++channel) {
        Interface c = entering(s, channel);
        vec3 inside = safeNormalize(refractedRay(c, p), -s.v);
        vec3 shown = mix(lightOfFacets(s.x, inside, channel, p), mirrored, mirroredShare(c, p));
        vec3 chosen = FIRST_CHANNEL == LAST_CHANNEL
            ? vec3(1.0)
            : vec3(equal(ivec3(0, 1, 2), ivec3(channel)));
        sum += chosen * shown;
    }
    return sum;
}

vec3 shownByFacets(Surface s, Refraction p) {
    vec3 across = dFdx(s.x);
    vec3 up = dFdy(s.x);
    vec3 sum = vec3(0.0);
    int rays = raysOfPixel();
    for (int i = 0; i < rays; ++i) {
        vec2 u = placeInPixel(i);
        vec3 aside = u.x * across + u.y * up;
        Surface each = s;
        each.x += aside;
        each.v = safeNormalize(s.v * s.range - aside, s.v);
        sum += shownTo(each, p);
    }
    return sum / float(rays);
}

vec3 refractedByFacets(Surface s, vec3 shaded, float alpha, Refraction p) {
    if (refractionFacetCount == 0) {
        return refracted(s, shaded, alpha, p);
    }
    vec3 shown = shownByFacets(s, p);
    vec3 limited = vec3(storable(shown.r), storable(shown.g), storable(shown.b));
    return mix(limited, shaded, alpha);
}
