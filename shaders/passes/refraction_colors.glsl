// SPDX-License-Identifier: MIT-0
// What a transparent body that bends colours apart shows of its surroundings: what passes through
// it, for each wavelength with a ray of its own, and what its surface mirrors.

vec3 shownThrough(Surface s, Refraction p) {
    vec3 r = 2.0 * dot(s.n, s.v) * s.n - s.v;
    vec3 mirrored = distantLight(r, dFdx(r), dFdy(r));
    Interface c = entering(s, 1);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < WAVELENGTHS; ++i) {
        Refraction one = forWavelength(i, p);
        Passage w = passageFrom(s, c, one);
        vec3 passed = lightThrough(s, w) * leftShare(w.way, one);
        sum += wavelengthShares(i) * mix(passed, mirrored, mirroredShare(c, one));
    }
    return sum;
}

// Half floats end at 65504; what is not a number is not light.
vec3 refracted(Surface s, vec3 shaded, float alpha, Refraction p) {
    vec3 shown = shownThrough(s, p);
    vec3 limited = vec3(storable(shown.r), storable(shown.g), storable(shown.b));
    return mix(limited, shaded, alpha);
}
