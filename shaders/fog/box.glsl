// SPDX-License-Identifier: MIT-0
#include "lib/fog_ray.glsl"

// The metres of the ray that lie in the box: from the last plane at which it enters to the first
// at which it leaves. Where both belong to one axis that is size / |direction|, which does not lose
// the digits of a thin box far away. Slabs: T. L. Kay and J. T. Kajiya, SIGGRAPH 1986.
float boxFogPath(FogRay ray, BoxFog p) {
    float from = 0.0;
    float to = ray.range;
    int enters = -1;
    int leaves = -2; // never an axis that was entered
    for (int axis = 0; axis < 3; ++axis) {
        float away = p.center[axis] - ray.eye[axis];
        float reach = 0.5 * p.size[axis];
        float slope = ray.direction[axis];
        if (abs(slope) < 1e-20) { // along the planes: between them or not
            if (abs(away) > reach) {
                return 0.0;
            }
        } else {
            float middle = away / slope;
            float halfWay = reach / abs(slope);
            if (middle - halfWay > from) {
                from = middle - halfWay;
                enters = axis;
            }
            if (middle + halfWay < to) {
                to = middle + halfWay;
                leaves = axis;
            }
        }
    }
    if (!(to > from)) {
        return 0.0;
    }
    if (enters == leaves) {
        return p.size[enters] / abs(ray.direction[enters]);
    }
    return to - from;
}

// exp(-density x), x the metres of the way that lie in the box. Bouguer 1729.
float boxFog(FogRay ray, BoxFog p) {
    return exp(-p.density * boxFogPath(ray, p));
}

vec3 boxFogColor(BoxFog p) {
    return p.color;
}
