// SPDX-License-Identifier: MIT-0
// Rusinkiewicz' angles (1998) of two directions.
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// The angle of (x, y) from the first axis, -pi .. pi; 0 where it has no length. Between steep bins
// the arc tangent of GLSL is not near enough: it may be 4096 units of the last place off.
float angleInPlane(float x, float y) {
    float size = max(abs(x), abs(y));
    if (!(size > 0.0)) {
        return 0.0;
    }
    float across = abs(y) / size;
    float along = abs(x) / size;
    float shrunk = 1.0 / sqrt(along * along + across * across);
    float a = angleOf(across * shrunk, along * shrunk);
    a = x < 0.0 ? PI - a : a;
    return y < 0.0 ? -a : a;
}

// The azimuth over pi, the difference angle over pi/2 and the square root of the half angle over
// pi/2: places in a table of measurements. d is half the difference of l and v: its part along n is
// -sin(half) sin(difference) cos(azimuth), its part along n x h is sin(difference) sin(azimuth).
// Swapping l and v turns the azimuth by pi, and counts as the same.
vec3 halfDifferencePlace(Directions d) {
    float S = sqrt(d.sin2h);
    float tilt = angleInPlane(d.nH, S);
    float difference = angleOf(sqrt(d.versineLh * (1.0 + d.lh)), d.lh);
    bool isLevel = !(S > 0.0); // h = n: the azimuth counts from the tangent
    float along = isLevel ? d.lt : (d.nv - d.nl) * d.lh;
    float across = isLevel ? d.lb : d.vt * d.lb - d.vb * d.lt;
    float azimuth = angleInPlane(along, across);
    azimuth = azimuth < 0.0 ? azimuth + PI : azimuth;
    return vec3(azimuth / PI, difference / (0.5 * PI), sqrt(tilt / (0.5 * PI)));
}
