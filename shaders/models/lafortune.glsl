// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/elementary.glsl"
#include "lib/gloss.glsl"

// max(0, Cx lt vt + Cy lb vb + Cz ln vn)^e for one channel, C = (Cx, Cy, Cz). The part that is the
// same in every azimuth is written with the exact versine of r.v (mirroring lobes, Cx + Cy < 0) or
// l.v (lobes back to the light), so that 1 - base is not formed from a rounded base, but where that
// may be.
float lafortunePower(Directions g, Lafortune p, vec3 C, float e) {
    float x = g.lt * g.vt;
    float y = g.lb * g.vb;
    float z = g.nl * g.nv;
    float base = C.x * x + C.y * y + C.z * z;
    if (p.falloff == LAFORTUNE_FALLOFF_ROUNDED) {
        return base > 0.0 ? exp2(min(e * log2(max(base, 1e-37)), 100.0)) : 0.0;
    }
    bool mirrors = C.x + C.y < 0.0;
    float turn = mirrors ? C.z : -C.z;
    float versine = mirrors ? g.versineRv : 2.0 * g.versineLh * (1.0 + g.lh);
    float gap = (1.0 - C.z) + C.z * versine - (C.x + turn) * x - (C.y + turn) * y;
    if (p.falloff == LAFORTUNE_FALLOFF_GAUSSIAN) {
        return base > 0.0 ? exp2(min(-1.4426950408889634 * e * gap, 100.0)) : 0.0;
    }
    return powNear1(gap, base, e);
}

// The lobe per channel, times pi or, with the factor (e + 2) / (2 pi) that makes the mirror lobe
// C = (-1, -1, 1) reflect all light at normal incidence, times (e + 2) / 2.
vec3 lafortuneLobe(Directions g, Lafortune p, vec3 Cx, vec3 Cy, vec3 Cz, vec3 e) {
    vec3 scale = vec3(PI);
    if (p.normalisation == LAFORTUNE_NORMALISATION_NORMALISED) {
        scale = 0.5 * e + vec3(1.0);
    }
    return scale * vec3(lafortunePower(g, p, vec3(Cx.x, Cy.x, Cz.x), e.x),
        lafortunePower(g, p, vec3(Cx.y, Cy.y, Cz.y), e.y),
        lafortunePower(g, p, vec3(Cx.z, Cy.z, Cz.z), e.z));
}

// Lafortune et al. 1997: f = rho / pi + sum of the lobes; pi f cos theta_l.
vec3 lafortune(Directions d, Lafortune p) {
    Directions g = alongGrain(d, p.tangentAngle);
    vec3 lobes = p.lobe1Color
        * lafortuneLobe(g, p, p.lobe1X, p.lobe1Y, p.lobe1Z, p.lobe1Exponent);
    if (p.lobes != LAFORTUNE_LOBES_ONE) {
        lobes += p.lobe2Color * lafortuneLobe(g, p, p.lobe2X, p.lobe2Y, p.lobe2Z, p.lobe2Exponent);
    }
    if (p.lobes == LAFORTUNE_LOBES_THREE) {
        lobes += p.lobe3Color * lafortuneLobe(g, p, p.lobe3X, p.lobe3Y, p.lobe3Z, p.lobe3Exponent);
    }
    return d.nl * (p.diffuseColor
        + glossed(lobes, p.gloss, p.glossMode == LAFORTUNE_GLOSS_MODE_LIMIT, 1.0));
}
