// SPDX-License-Identifier: MIT-0

// For a material whose model is not known: hatched, so that nobody takes it for the real look.
vec3 fallback(Surface s) {
    float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / 16.0) < 0.5 ? 0.12 : 0.3;
    return vec3(stripe * (0.3 + 0.7 * dot(s.n, s.v)));
}
