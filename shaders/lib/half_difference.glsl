// SPDX-License-Identifier: MIT-0
// Rusinkiewicz' angles (1998) of two directions.
#include "lib/directions.glsl"

// The azimuth over pi, the difference angle over pi/2 and the square root of the half angle over
// pi/2: places in a table of measurements. d is half the difference of l and v: its part along n is
// -sin(half) sin(difference) cos(azimuth), its part along n x h is sin(difference) sin(azimuth).
// Swapping l and v turns the azimuth by pi, and counts as the same.
vec3 halfDifferencePlace(Directions d) {
    float S = sqrt(d.sin2h);
    float tilt = atan(S, d.nH);
    float difference = atan(sqrt(d.versineLh * (1.0 + d.lh)), d.lh);
    bool isLevel = !(S > 0.0); // h = n: the azimuth counts from the tangent
    float along = isLevel ? d.lt : (d.nv - d.nl) * d.lh;
    float across = isLevel ? d.lb : d.vt * d.lb - d.vb * d.lt;
    float azimuth = along == 0.0 && across == 0.0 ? 0.0 : atan(across, along);
    azimuth = azimuth < 0.0 ? azimuth + PI : azimuth;
    return vec3(azimuth / PI, difference / (0.5 * PI), sqrt(tilt / (0.5 * PI)));
}
