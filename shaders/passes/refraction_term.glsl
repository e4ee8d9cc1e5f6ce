// SPDX-License-Identifier: MIT-0
// What the surface of a body mirrors by the material's Fresnel term. Light goes the same way out as
// in: from within it is the share at the angle outside, and all where nothing leaves.

Term surfaceTerm;

float termShare(Interface c, Refraction p) {
    Incidence i = incidenceBetween(c.l, c.n);
    if (c.leaves) {
        vec3 outside = refractedRay(c, p);
        if (dot(outside, outside) < 0.5) {
            return 1.0;
        }
        i = incidenceBetween(outside, -c.n);
    }
    return OF_FACES(dot(termSeenBy(c), termReflectance(i, surfaceTerm)));
}
