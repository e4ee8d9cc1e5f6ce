// SPDX-License-Identifier: MIT-0
// The surface of a body that is farthest from the eye, as the plane that touches it in each pixel.

uniform vec4 refractionBody; // a ball around the body: its middle, its radius

void main() {
    vec3 v = safeNormalize(toEye, vec3(0.0, 0.0, 1.0));
    vec3 n = -shadingNormal(v);
    storedColor = vec4(n, dot(n, worldPosition - refractionBody.xyz));
}
