// SPDX-License-Identifier: MIT-0
// Light of different wavelengths in a body that bends them apart. Each stands for a part of the
// spectrum: its shares of the three channels, which add up to 1, and the body's index for it.

vec3 wavelengthShares(int wavelength) {
    return objectData[FIRST_WAVELENGTH + wavelength].rgb;
}

// The body as that light alone meets it, in whichever channel.
Refraction forWavelength(int wavelength, Refraction p) {
    p.WAVELENGTH_INDEX = objectData[FIRST_WAVELENGTH + wavelength].w;
    p.WAVELENGTH_DISPERSION = 0.0;
    return p;
}
