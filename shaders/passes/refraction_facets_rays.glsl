// SPDX-License-Identifier: MIT-0
// The rays of a pixel: each round of samples has one, through a place of its own within the pixel.

// One of them, on the plane of the triangle. Its way to the depth of a metre changes evenly from
// pixel to pixel, which where it meets the plane does not.
Surface besideMiddle(Surface s, vec3 way, vec3 aside, vec3 face) {
    vec3 ray = way + aside;
    float into = min(dot(face, ray), -1e-9);
    Surface each = s;
    each.x += (aside - dot(face, aside) / into * ray) / gl_FragCoord.w;
    each.v = safeNormalize(-ray, s.v);
    return each;
}

vec3 shownByFacets(Surface s, Refraction p) {
    vec3 way = -gl_FragCoord.w * toEye;
    vec3 across = dFdx(way);
    vec3 up = dFdy(way);
    vec3 face = faceNormal(s.v);
    vec3 sum = vec3(0.0);
    int rays = raysOfPixel();
    for (int i = 0; i < rays; ++i) {
        vec2 u = placeInPixel(i);
        sum += shownTo(besideMiddle(s, way, u.x * across + u.y * up, face), p);
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
