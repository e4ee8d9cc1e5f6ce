// SPDX-License-Identifier: MIT-0
// How the surface bends at a pixel, for the normal on the viewer's side.
in vec3 drawnCurvature;
in vec3 drawnCurvatureMixed;

float drawnSide() {
    return dot(drawnNormal, drawnEye) < 0.0 ? -1.0 : 1.0;
}
