// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/gloss.glsl"
#include "lib/math.glsl"
#include "lib/spectrum.glsl"

// exp(-(x / width)^2) with an area of 1.
float gratingLine(float x, float width) {
    return exp2(-1.4426950408889634 * sqr(x / width)) * (0.56418958354775629 / width);
}

// The share of the light in each of the two directions of the first order, of what the mirror
// leaves; that of each further order is the falloff times that of the one before.
float gratingShare(Grating p) {
    float sum = 0.0;
    float weight = 1.0;
    for (int order = 1; order <= p.orders; ++order) {
        sum += weight;
        weight *= p.falloff;
    }
    return 0.5 * (1.0 - p.mirror) / sum;
}

// With b across the grooves, order m sends light of the wavelength lambda where
//   d |b.(l + v)| = m lambda
// and along the grooves, t, light is mirrored. In the plane of l and v seen from above, whose area
// is cos(theta) times the solid angle, order m is therefore a line of one wavelength each; a
// channel that sees S(lambda) of it sees E d / m S(d |b.(l + v)| / m), E the order's share. Where
// 1/d varies by a share of itself from groove to groove, so does the wavelength that order m sends
// somewhere, by the same share in every order: each order's S is as much wider. Lines are as wide
// along the grooves as the slopes of the surface make them: twice the slope's width.
vec3 grating(Directions d, Grating p) {
    Directions g = alongGrain(d, p.tangentAngle);
    float width = 2.0 * slopeWidth(p.roughness);
    vec3 across = vec3(p.mirror * gratingLine(g.bH, width));
    float share = gratingShare(p);
    vec3 scale = srgbWavelengths() / p.wavelength;
    for (int order = 1; order <= p.orders; ++order) {
        float spread = p.grooveDistance / float(order);
        across += share * spread * channelsSee(spread * abs(g.bH), p.irregularity, scale);
        share *= p.falloff;
    }
    vec3 lobe = PI * d.nl * gratingLine(g.tH, width) * across;
    return glossed(p.specularColor * lobe, p.gloss, p.glossMode == GRATING_GLOSS_MODE_LIMIT, d.nl);
}
