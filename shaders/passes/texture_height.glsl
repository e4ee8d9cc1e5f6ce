// SPDX-License-Identifier: MIT-0

in vec2 evenUv;

// The normal of a surface that is raised along its normal (M. S. Mikkelsen, Bump Mapping
// Unparametrized Surfaces on the GPU, 2010, listing 2): the slope from the heights one pixel to the
// right and above, the strength in metres. No tangents are needed. At a triangle's edge `place` is
// not that of the pixel's middle, and its derivatives mean nothing.
Surface heightMapped(Surface s, sampler2D image, vec4 channel, int rows) {
    vec2 place = imagePlace(rows);
    vec2 even = vec2(dot(objectData[rows].xy, evenUv), dot(objectData[rows + 1].xy, evenUv));
    float here = dot(texture(image, place), channel);
    float right = dot(texture(image, place + dFdx(even)), channel);
    float above = dot(texture(image, place + dFdy(even)), channel);
    vec3 dx = -dFdx(toEye);
    vec3 dy = -dFdy(toEye);
    vec3 r1 = cross(dy, s.n);
    vec3 r2 = cross(s.n, dx);
    float area = dot(dx, r1);
    float raised = imageFront(s) * objectData[rows].w * (area < 0.0 ? -1.0 : 1.0);
    vec3 n = abs(area) * s.n - raised * ((right - here) * r1 + (above - here) * r2);
    return perturbed(s, safeNormalize(n, s.n));
}
