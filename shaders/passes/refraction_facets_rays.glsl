// SPDX-License-Identifier: MIT-0
// The rays of a pixel: each round of samples has one, through a place of its own within the pixel.

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
