// SPDX-License-Identifier: MIT-0

// The surface in its own axes. A model that is the same however a surface is turned sees no
// difference, and drivers work out beforehand what depends on nothing else.
Surface levelled(Surface s) {
    s.n = vec3(0.0, 0.0, 1.0);
    s.t = vec3(1.0, 0.0, 0.0);
    s.b = vec3(0.0, 1.0, 0.0);
    return s;
}
