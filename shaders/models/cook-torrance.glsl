// SPDX-License-Identifier: MIT-0
#include "lib/cheap_microfacet.glsl"
#include "lib/directions.glsl"
#include "lib/fresnel.glsl"
#include "lib/gaussians.glsl"
#include "lib/gloss.glsl"
#include "lib/masking.glsl"
#include "lib/microfacet.glsl"
#include "lib/powers.glsl"

// The width of the facets' slopes: the RMS slope of the Beckmann surface that is masked alike, or
// alpha of the GGX one. The Gaussians are Beckmann's for small angles; for the power Walter et al.
// 2007, section 5.2, take the Beckmann surface of alpha^2 = 2 / (e + 2).
float cookTorranceWidth(CookTorrance p) {
    float width = slopeWidth(p.roughness);
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_TROWBRIDGE_REITZ) {
        return trowbridgeReitzWidth(width);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_TORRANCE_SPARROW) {
        return gaussianWidth(width);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_PHONG) {
        return sqrt(2.0 / (phongExponent(width) + 2.0));
    }
    return width;
}

bool cookTorranceIsGgx(CookTorrance p) {
    return p.distribution == COOK_TORRANCE_DISTRIBUTION_GGX
        || p.distribution == COOK_TORRANCE_DISTRIBUTION_TROWBRIDGE_REITZ;
}

// D in 1/sr, integral of D cos = 1.
float cookTorranceD(Directions d, CookTorrance p) {
    float width = cookTorranceWidth(p);
    if (cookTorranceIsGgx(p)) {
        return ggxDistribution(d.sin2h, d.cos2h, width);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_BECKMANN) {
        return beckmannDistribution(d.sin2h, d.cos2h, width);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_PHONG) {
        return cosinePowerDistribution(d.sin2h, d.cos2h, phongExponent(slopeWidth(p.roughness)));
    }
    return gaussianLobe(halfVersine(d), width) / gaussianNormaliser(width);
}

// The same with fewer operations, for all but GGX, of which nothing can be left out.
float cookTorranceReducedD(Directions d, CookTorrance p) {
    float width = cookTorranceWidth(p);
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_BECKMANN) {
        return beckmannSeries(d.sin2h, d.cos2h, width);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_PHONG) {
        float e = phongExponent(slopeWidth(p.roughness));
        return (e + 2.0) * gaussianPower(halfVersine(d), d.nh, e) / (2.0 * PI);
    }
    return gaussianLobeBy(ANGLE_SMALL, halfVersine(d), width) / gaussianNormaliser(width);
}

// D as it is computed, in 1/sr.
float cookTorranceDistribution(Directions d, CookTorrance p) {
    if (p.facets == COOK_TORRANCE_FACETS_REDUCED && !cookTorranceIsGgx(p)) {
        return cookTorranceReducedD(d, p);
    }
    return cookTorranceD(d, p);
}

// What turns D into pi times the distribution as printed: Blinn's are 1 at the peak, and Beckmann's
// lacks the 1/pi.
float cookTorrancePrinted(CookTorrance p) {
    float width = cookTorranceWidth(p);
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_TROWBRIDGE_REITZ) {
        return PI * width * width;
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_PHONG) {
        return 2.0 * PI / (phongExponent(slopeWidth(p.roughness)) + 2.0);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_TORRANCE_SPARROW) {
        return gaussianNormaliser(width);
    }
    if (p.distribution == COOK_TORRANCE_DISTRIBUTION_BLINN_GAUSSIAN) {
        return p.gaussianConstant * gaussianNormaliser(width);
    }
    return PI;
}

// c / G1 of one direction.
float cookTorranceUnmasked(CookTorrance p, float c, float s2) {
    float width = cookTorranceWidth(p);
    if (p.masking == COOK_TORRANCE_MASKING_SCHLICK_SMITH
        || p.shadowing == COOK_TORRANCE_SHADOWING_SCHLICK) {
        return schlickUnmasked(c, (cookTorranceIsGgx(p) ? 0.5 : 0.79788456080286536) * width);
    }
    if (cookTorranceIsGgx(p)) {
        return ggxUnmasked(c, s2, width);
    }
    if (p.shadowing == COOK_TORRANCE_SHADOWING_WALTER) {
        return walterUnmasked(c, s2, width);
    }
    return beckmannUnmasked(c, s2, width);
}

// G / (4 n.v). "None" is G = (n.l)(n.v), which leaves nothing of the term.
float cookTorranceVisibility(Directions d, CookTorrance p) {
    if (p.shadowing == COOK_TORRANCE_SHADOWING_NONE) {
        return 0.25 * d.nl;
    }
    if (p.masking == COOK_TORRANCE_MASKING_V_CAVITY) {
        return vCavityVisibility(d.nl, d.nv, d.nH, d.HH);
    }
    if (p.shadowing == COOK_TORRANCE_SHADOWING_SCHLICK && cookTorranceIsGgx(p)
        && p.masking == COOK_TORRANCE_MASKING_SMITH_CORRELATED) {
        return hammonVisibility(d.nl, d.nv, cookTorranceWidth(p));
    }
    float Sl = cookTorranceUnmasked(p, d.nl, d.sin2l);
    float Sv = cookTorranceUnmasked(p, d.nv, d.sin2v);
    if (p.masking == COOK_TORRANCE_MASKING_SMITH_CORRELATED) {
        return correlatedVisibility(d.nl, d.nv, Sl, Sv);
    }
    return separableVisibility(d.nl, Sl, Sv);
}

// G, for plots of the masking alone.
float cookTorranceMasking(Directions d, CookTorrance p) {
    return 4.0 * d.nv * cookTorranceVisibility(d, p);
}

Incidence cookTorranceIncidence(Directions d, CookTorrance p) {
    if (p.fresnelCosine == COOK_TORRANCE_FRESNEL_COSINE_LIGHT) {
        return incidenceAt(d.nl, d.sin2l);
    }
    if (p.fresnelCosine == COOK_TORRANCE_FRESNEL_COSINE_VIEW) {
        return incidenceAt(d.nv, d.sin2v);
    }
    return halfIncidence(d);
}

// What the mirrors leave of the light for the base, seen from the viewer: 1 - s R with Schlick's
// R = R0 + (1 - R0) (1 - q)^5 (CGF 13(3), 1994) and s the strength of the mirrors. A rough surface
// reflects about as much as a smooth one does at the cosine q with q^2 = (n.v)^2 + 0.4 w^2 /
// (w + 0.025), which is fitted to GGX of width w with Smith's masking by height: of the light that
// clear materials of index 1.33 to 1.8 reflect it takes 0.03 too little to 0.08 too much.
vec3 cookTorranceLeft(Directions d, CookTorrance p) {
    float width = cookTorranceWidth(p);
    float q = sqrt(d.nv * d.nv + 0.4 * width * width / (width + 0.025));
    vec3 passed = vec3(1.0) - slotFresnel(incidenceOf(1.0), p.fresnel);
    vec3 strength = p.specularColor;
    if (p.glossMode == COOK_TORRANCE_GLOSS_MODE_MULTIPLY) {
        strength *= p.gloss;
    }
    return (vec3(1.0) - strength) + strength * passed * fifthRise(min(q, 1.0));
}

// s R_s + d R_d of Cook and Torrance 1982, with R_s = D G F / (4 (n.l)(n.v)). Their
// print has D' = pi D and F D' G / (pi (n.l)(n.v)), which is 4 R_s.
vec3 cookTorrance(Directions d, CookTorrance p) {
    float specularShare = 1.0;
    float diffuseShare = 1.0;
    vec3 base = p.diffuseColor;
    if (p.balance == COOK_TORRANCE_BALANCE_SPLIT) {
        specularShare = p.specularShare;
        diffuseShare = 1.0 - p.specularShare;
    }
    if (p.balance == COOK_TORRANCE_BALANCE_LEFT) {
        base *= cookTorranceLeft(d, p);
    }
    float scale = PI;
    if (p.scale == COOK_TORRANCE_SCALE_1982) {
        scale = 4.0 * cookTorrancePrinted(p);
    }
    vec3 F = slotFresnel(cookTorranceIncidence(d, p), p.fresnel);
    float lobe = scale * cookTorranceDistribution(d, p) * cookTorranceVisibility(d, p);
    return base * (diffuseShare * d.nl)
        + glossedLobe(p.specularColor * F, specularShare * lobe, p.gloss,
            p.glossMode == COOK_TORRANCE_GLOSS_MODE_LIMIT, d.nl);
}
