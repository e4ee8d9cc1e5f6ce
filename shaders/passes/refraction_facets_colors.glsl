// SPDX-License-Identifier: MIT-0
// What one ray of a pixel sees by a body of facets that bends colours apart.

vec3 shownTo(Surface s, Refraction p) {
    vec3 mirrored = lightFar(2.0 * dot(s.n, s.v) * s.n - s.v);
    Interface c = entering(s, 1);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < WAVELENGTHS; ++i) {
        Refraction one = forWavelength(i, p);
        vec3 inside = safeNormalize(refractedRay(c, one), -s.v);
        vec3 passed = lightOfFacets(s.x, inside, 1, one);
        sum += wavelengthShares(i) * mix(passed, mirrored, mirroredShare(c, one));
    }
    return sum;
}
