// SPDX-License-Identifier: MIT-0
// What the three channels of a picture see of light of one wavelength.

// A bell around `middle` with its own width on either side, whose area is 1.
float spectralBell(float wavelength, float middle, float below, float above) {
    float t = (wavelength - middle) / (wavelength < middle ? below : above);
    return exp2(-0.72134752044448170 * t * t) * (0.79788456080286536 / (below + above));
}

// Per channel, per nanometre; the area under each is 1, so that light of all wavelengths is white.
// Fitted to the colour matching functions of CIE 1931 (C. Wyman, P.-P. Sloan and P. Shirley, Simple
// Analytic Approximations to the CIE XYZ Color Matching Functions, JCGT 2(2), 2013) in linear
// sRGB, at most 0.09 of a channel's peak off; what is negative there, since no display shows pure
// colours, is 0 here. Wavelengths in nm, >= 0.
vec3 channelsSee(float wavelength) {
    float red = 0.9554 * spectralBell(wavelength, 602.5, 23.0, 30.6);
    float violet = 0.0446 * spectralBell(wavelength, 438.5, 13.7, 11.5);
    float green = spectralBell(wavelength, 541.0, 30.1, 30.1);
    float blue = spectralBell(wavelength, 445.2, 17.6, 26.5);
    return vec3(red + violet, green, blue);
}
