// SPDX-License-Identifier: MIT-0
// Each wavelength has a ray of its own: the term counts for it as it does for what sees it.

vec3 channelsOfRay = vec3(0.0);

vec3 termSeenBy(Interface c) {
    return channelsOfRay;
}

Refraction termForWavelength(int wavelength, Refraction p) {
    vec3 shares = wavelengthShares(wavelength);
    channelsOfRay = shares / max(shares.r + shares.g + shares.b, 1e-30);
    return forWavelength(wavelength, p);
}
