// SPDX-License-Identifier: MIT-0
// Stands behind the block: what it sends from a direction of its own, E / pi.

vec3 environmentRadiance(vec3 d, Environment p) {
    SkyRay o;
    o.d = d;
    o.picture = ENVIRONMENT_PICTURE(d);
    return ENVIRONMENT_CUT(environmentLimited(environmentValue(o, p)), p);
}
