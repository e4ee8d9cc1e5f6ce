// SPDX-License-Identifier: MIT-0
// What the three channels of a picture see of light of one wavelength.
#include "lib/math.glsl"

// A bell around `middle` with its own width on either side, whose area is 1, where each wavelength
// is spread by `uneven` of itself: variances add up. Nothing is spread below 0, so the lower side is
// spread by `uneven / (1 + 2 uneven)`, at most a third, which leaves less than 0.001 there.
// Beside the true mean over uneven grooves at most 0.03 of the peak is off at 0.03, 0.09 at 0.1.
float spectralBell(float wavelength, float middle, float below, float above, float uneven) {
    float added = uneven * middle;
    float lower = sqrt(sqr(below) + sqr(added / (1.0 + 2.0 * uneven)));
    float upper = sqrt(sqr(above) + sqr(added));
    float t = (wavelength - middle) / (wavelength < middle ? lower : upper);
    return exp2(-0.72134752044448170 * t * t) * (0.79788456080286536 / (lower + upper));
}

// The wavelengths in nm that stand for the primaries of sRGB, for which channelsSee() is fitted.
vec3 srgbWavelengths() {
    return vec3(611.4, 549.1, 464.3);
}

// Per channel, per nanometre; the area under each is 1, so that light of all wavelengths is white.
// Fitted to the colour matching functions of CIE 1931 (C. Wyman, P.-P. Sloan and P. Shirley, Simple
// Analytic Approximations to the CIE XYZ Color Matching Functions, JCGT 2(2), 2013) in linear
// sRGB, at most 0.1 of a channel's peak off; what is negative there, since no display shows pure
// colours, is 0 here. Wavelengths in nm, >= 0; `uneven` is the standard deviation of what each
// arrives as over the wavelength itself, 0 to 1. `scale` is srgbWavelengths() over the wavelengths
// that stand for red, green and blue: what each channel sees is stretched to these.
vec3 channelsSee(float wavelength, float uneven, vec3 scale) {
    vec3 moved = wavelength * scale;
    float red = 0.9554 * spectralBell(moved.r, 602.5, 23.0, 30.6, uneven);
    float violet = 0.0446 * spectralBell(moved.r, 438.5, 13.7, 11.5, uneven);
    float green = spectralBell(moved.g, 541.0, 30.1, 30.1, uneven);
    float blue = spectralBell(moved.b, 445.2, 17.6, 26.5, uneven);
    return scale * vec3(red + violet, green, blue);
}
