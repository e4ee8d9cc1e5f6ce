// SPDX-License-Identifier: MIT-0
// Strands that are lit by themselves: the directions of light and viewer in their own frame.

in vec3 strandAlong;

vec3 strandInFrame; // the strand's unit direction along s.t, s.b and s.n

void turnStrand(Surface s) {
    vec3 along = safeNormalize(strandAlong, s.n);
    strandInFrame = safeNormalize(vec3(dot(along, s.t), dot(along, s.b), dot(along, s.n)),
        vec3(0.0, 0.0, 1.0));
}

vec3 strandLight(Directions d) {
    vec3 across = anyTangent(strandInFrame);
    vec3 out1 = cross(strandInFrame, across);
    vec3 l = vec3(d.lt, d.lb, d.nl);
    vec3 v = vec3(d.vt, d.vb, d.nv);
    d.lt = dot(l, strandInFrame);
    d.lb = dot(l, across);
    d.nl = dot(l, out1);
    d.vt = dot(v, strandInFrame);
    d.vb = dot(v, across);
    d.nv = dot(v, out1);
    return shellsOwn(d, shells);
}
