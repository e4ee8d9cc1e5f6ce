// SPDX-License-Identifier: MIT-0

// What a sky above and a ground below, each of one colour, send to a surface: the share of the sky
// in the cosine-weighted half of all directions that the normal n faces is (1 + n.up) / 2.
vec3 hemisphereLight(Surface s, vec3 sky, vec3 ground, vec3 up) {
    return mix(ground, sky, clamp(0.5 + 0.5 * dot(s.n, up), 0.0, 1.0));
}
