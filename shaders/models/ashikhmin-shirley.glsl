// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/elementary.glsl"
#include "lib/fresnel.glsl"
#include "lib/gloss.glsl"
#include "lib/powers.glsl"

// -ln(n.h) over the squared sine of n.h on the scale of H; cheaply (1 - n.h) over it.
float ashikhminShirleyFall(Directions d, AshikhminShirley p) {
    if (p.falloff == ASHIKHMIN_SHIRLEY_FALLOFF_GAUSSIAN) {
        return 1.0 / ((d.sin2h + d.cos2h) * (1.0 + d.nh));
    }
    return minusLnCosBySin2(d.sin2h, d.cos2h);
}

// (n.h)^e from (n.h)^2 as it is rounded. Where light and viewer graze the surface on opposite sides
// it loses as many digits as l + v is shorter than they are.
float ashikhminShirleyRounded(Directions d, float e) {
    return roundedPower(d.cos2h / max(d.HH, 1e-30), 0.5 * e);
}

// (n.h)^(nu cos^2 phi + nv sin^2 phi) sqrt((nu + 1)(nv + 1)) with phi the azimuth of h. The
// exponent is (nu (H.t)^2 + nv (H.b)^2) / sin^2 on the scale of H, and -ln cos / sin^2 has a limit
// at h = n.
float ashikhminShirleyLobe(Directions d, AshikhminShirley p) {
    if (p.shininessYEqual) { // no azimuth is left
        if (p.falloff == ASHIKHMIN_SHIRLEY_FALLOFF_ROUNDED) {
            return ashikhminShirleyRounded(d, p.shininessX) * (p.shininessX + 1.0);
        }
        float exponent = p.shininessX * d.sin2h * ashikhminShirleyFall(d, p);
        return exp2(-1.4426950408889634 * exponent) * (p.shininessX + 1.0);
    }
    Directions g = alongGrain(d, p.tangentAngle);
    float weight = p.shininessX * sqr(g.tH) + p.shininessY * sqr(g.bH);
    float peak = sqrt((p.shininessX + 1.0) * (p.shininessY + 1.0));
    if (p.falloff == ASHIKHMIN_SHIRLEY_FALLOFF_ROUNDED) {
        return peak * ashikhminShirleyRounded(d, weight / max(d.sin2h, 1e-30));
    }
    return peak * exp2(-1.4426950408889634 * weight * ashikhminShirleyFall(d, p));
}

// The density of half vectors, in 1/sr, whose integral is 1; for plots.
float ashikhminShirleyDistribution(Directions d, AshikhminShirley p) {
    return ashikhminShirleyLobe(d, p) / (2.0 * PI);
}

// Ashikhmin and Shirley 2000, equations 4 and 5, with F the slot's reflectance at h.l and Rs that
// facing the surface; pi f cos theta_l. 28/23 is the exact normaliser of the diffuse part.
vec3 ashikhminShirley(Directions d, AshikhminShirley p) {
    vec3 F = slotFresnel(halfIncidence(d), p.fresnel);
    float lobe = 0.125 * ashikhminShirleyLobe(d, p) * (d.nl / max(d.nl, d.nv))
        / max(d.lh, 1e-20);
    vec3 diffuse = p.diffuseColor * d.nl;
    if (p.diffuseKind == ASHIKHMIN_SHIRLEY_DIFFUSE_KIND_COUPLED
        && p.base == ASHIKHMIN_SHIRLEY_BASE_EXACT) {
        vec3 Rs = p.specularColor * slotFresnel(incidenceOf(1.0), p.fresnel);
        float rise = fifthRise(0.5 * d.nl) * fifthRise(0.5 * d.nv);
        diffuse *= (vec3(1.0) - Rs) * (1.2173913043478261 * rise);
    }
    vec3 highlight = p.specularColor * F * lobe;
    return diffuse
        + glossed(highlight, p.gloss, p.glossMode == ASHIKHMIN_SHIRLEY_GLOSS_MODE_LIMIT, d.nl);
}
