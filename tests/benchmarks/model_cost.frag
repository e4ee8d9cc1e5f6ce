// SPDX-License-Identifier: GPL-3.0-or-later
// One light on the front of a sphere that fills the target: what a model costs apart from the rest
// of a frame. The program that includes this defines TARGET_SIZE and `shaded`. A textbook form
// reads the vectors; what a model does not use of them and of Directions the compiler drops.
layout(location = 0) out vec4 color;

vec3 N;
vec3 T;
vec3 B;
vec3 L;
vec3 V;

vec3 shaded(Directions d);

void main() {
    vec2 place = 1.3 * gl_FragCoord.xy / TARGET_SIZE - vec2(0.65);
    N = vec3(place, sqrt(1.0 - dot(place, place)));
    T = normalize(vec3(N.z, 0.0, -N.x));
    B = cross(N, T);
    L = normalize(vec3(1.5, 2.0, 4.0) - N);
    V = normalize(vec3(0.2, 0.1, 4.0) - N);
    color = vec4(shaded(directions(N, T, B, L, V)), 1.0);
}
