// SPDX-License-Identifier: MIT-0
// What blocks of kind "shadows" are made of.

// Place `i` of `count` in the unit disk, evenly spread (H. Vogel, A better way to construct the
// sunflower head, 1979) and turned from pixel to pixel, so that few places make no bands.
vec2 shadowDisk(ShadowPoint s, int i, int count) {
    float angle = 2.39996323 * float(i) + s.turn;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// The direction of the first place, and those of the others one after the other: a sine and a cosine
// for each place take longer than what is looked up there.
vec2 firstShadowWay(ShadowPoint s) {
    return vec2(cos(s.turn), sin(s.turn));
}

vec2 nextShadowWay(vec2 way) {
    const vec2 TURN = vec2(-0.737368878, 0.675490294); // cosine and sine of the golden angle
    return vec2(way.x * TURN.x - way.y * TURN.y, way.y * TURN.x + way.x * TURN.y);
}

bool isInShadowMap(ShadowRay ray) {
    return all(greaterThan(ray.place.xy, vec2(0.0))) && all(lessThan(ray.place.xy, vec2(1.0)));
}

// The corner between the four texels around a place: what is read there does not depend on how a
// device rounds.
vec3 shadowCorner(ShadowRay ray, vec2 size) {
    return vec3((floor(ray.place.xy * size - 0.5) + 1.0) / size, ray.place.z);
}

// The share of light that passes `offset` metres beside the point, by the four texels around.
float shadowLit(ShadowPoint s, vec2 offset) {
    ShadowRay ray = shadowRay(s, offset);
    if (!isInShadowMap(ray)) {
        return 1.0;
    }
    vec2 size = vec2(textureSize(shadowMaps, 0).xy);
    vec2 f = fract(ray.place.xy * size - 0.5);
    vec4 depths = textureGather(shadowMaps, shadowCorner(ray, size));
    vec4 lit = step(vec4(min(ray.stored, 1.0)), depths); // where nothing is they are 1
    return mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
}

// What is in the way there. x: its metres in front of the surface, summed; y: how many texels.
vec2 shadowBlockers(ShadowPoint s, vec2 offset) {
    ShadowRay ray = shadowRay(s, offset);
    if (!isInShadowMap(ray)) {
        return vec2(0.0);
    }
    vec2 size = vec2(textureSize(shadowMaps, 0).xy);
    vec4 depths = shadowDepths(s, textureGather(shadowMaps, shadowCorner(ray, size)));
    vec4 gaps = vec4(ray.depth) - depths;
    vec4 blocks = step(vec4(ray.doubt), gaps);
    return vec2(ray.stretch * dot(blocks, max(gaps, vec4(0.0))), dot(blocks, vec4(1.0)));
}

// Half the angle under which the light is seen, as a slope: of a light from very far away from its
// own angle, of another from its radius in metres.
float shadowSlope(ShadowPoint s, float halfAngle, float radius) {
    return s.isParallel ? tan(min(halfAngle, 1.5)) : radius * s.inverseRange;
}

// The half-width in metres of the shadow's edge `gap` metres behind what casts it. At most the
// slope of a light of 90 degrees.
float shadowEdge(ShadowPoint s, float slope, float gap) {
    float edge = slope * gap / max(1.0 - gap * s.inverseRange, 0.05);
    return s.isParallel ? edge : min(edge, 1.0 / s.inverseRange);
}

// Metres to the farthest thing that can be in the way.
float shadowReach(ShadowPoint s) {
    ShadowRay ray = shadowRay(s, vec2(0.0));
    return max(ray.stretch * (ray.depth - s.view.near), 0.0);
}

// What is in the way within `radius`. x: its metres in front of the surface, y: the share of the
// places. Where something is in the way of the point itself, that one's metres at most.
vec2 shadowFound(ShadowPoint s, float radius, int taps) {
    vec2 centre = shadowBlockers(s, vec2(0.0));
    vec2 found = centre;
    vec2 way = firstShadowWay(s);
    float each = radius * inversesqrt(float(taps));
    for (int i = 0; i < taps; ++i) {
        found += shadowBlockers(s, each * sqrt(float(i) + 0.5) * way);
        way = nextShadowWay(way);
    }
    float gap = found.x / max(found.y, 1.0);
    gap = centre.y > 0.0 ? min(gap, centre.x / centre.y) : gap;
    return vec2(gap, found.y / (4.0 * float(taps + 1)));
}

// The widest disk on the surface's plane that stays well behind what is `gap` in front of the
// point: beyond it that would be lit where it should be dark, close to where the two touch.
float shadowWidest(ShadowPoint s, float gap) {
    float nl = dot(s.l, s.n);
    return 0.5 * gap / (safeSqrt(1.0 - sqr(nl)) / nl + s.rise);
}

// The mean share of light over a disk.
float shadowMean(ShadowPoint s, float radius, int taps) {
    float lit = 0.0;
    vec2 way = firstShadowWay(s);
    float each = radius * inversesqrt(float(taps));
    for (int i = 0; i < taps; ++i) {
        lit += shadowLit(s, each * sqrt(float(i) + 0.5) * way);
        way = nextShadowWay(way);
    }
    return lit / float(taps);
}
