// SPDX-License-Identifier: MIT-0
// Where on the surface a pixel is, along the object's axes.

in vec3 drawnPlace;
in vec3 drawnNormal;
in vec3 drawnEye;

vec3 drawnView() {
    return safeNormalize(drawnEye, vec3(0.0, 0.0, 1.0));
}

vec3 drawnFacing() {
    vec3 v = drawnView();
    vec3 n = safeNormalize(drawnNormal, v);
    return dot(n, v) < 0.0 ? -n : n;
}

// How wide a pixel of the picture is there, in metres across the view.
float drawnPixel() {
    vec3 v = drawnView();
    float angle = 0.5 * (length(dFdx(v)) + length(dFdy(v)));
    return max(angle * length(drawnEye) / max(viewData[4].w, 1e-6), 1e-9);
}
