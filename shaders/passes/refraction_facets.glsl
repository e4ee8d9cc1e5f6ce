// SPDX-License-Identifier: MIT-0
// A convex body of flat facets: a ray is followed from facet to facet and splits at each, as its
// planes say.

const int MAX_FACETS = 128;

// The outward unit normals, and these times a place of the plane seen from the middle of the body.
uniform vec4 refractionFacets[MAX_FACETS];
uniform int refractionFacetCount; // 0: the body is no such one

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
