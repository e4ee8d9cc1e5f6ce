// SPDX-License-Identifier: MIT-0
#include "lib/anisotropy.glsl"
#include "lib/fresnel.glsl"
#include "lib/gloss.glsl"
#include "lib/lobes.glsl"
#include "lib/ridges.glsl"

// The highlight (n.h)^e of all points that are lit and seen, averaged over what is seen of one
// period.
float poulinFournierLobe(Directions g, PoulinFournier p, vec2 arc, AcrossRidges l,
    AcrossRidges v, float floorShare) {
    float hb = g.bH;
    float side = hb < 0.0 ? -1.0 : 1.0;
    float plane2 = g.nH * g.nH + hb * hb;
    float inPlane = max(sqrt(plane2), 1e-20);
    vec3 h = vec3(side * angleOf(abs(hb) / inPlane, g.nH / inPlane), sqr(g.tH), plane2);
    vec2 light = vec2(0.5 * PI, 0.0);
    float ridges = 1.0;
    float flatPart = powSC(g.sin2h, g.cos2h, p.shininess);
    float scale = 1.0;
    if (p.normalisation == POULIN_FOURNIER_NORMALISATION_NORMALISED) {
        light = vec2(l.horizon, l.side);
        ridges = l.across;
        flatPart *= g.nl;
        scale = blinnNormalisation(p.shininess);
    }
    ridges *= ridgeLobe(arc, h, p.shininess, vec2(v.horizon, v.side), light)
        / (p.spacing * max(v.cosine, 1e-20));
    return scale * (ridges + floorShare * flatPart);
}

// The average over one period, across what the viewer sees of it: lit and seen arcs of the ridges
// (diffuse part in closed form) and the lit and seen strip of the floor, which is flat.
vec3 poulinFournier(Directions d, PoulinFournier p) {
    Directions g = alongGrain(d, p.tangentAngle);
    AcrossRidges l = acrossRidges(g.nl, g.lb);
    AcrossRidges v = acrossRidges(g.nv, g.vb);
    vec2 arc = commonArc(ridgeArc(l, p.spacing, p.height), ridgeArc(v, p.spacing, p.height));
    vec2 strip = commonArc(floorStrip(l, p.spacing, p.height), floorStrip(v, p.spacing, p.height));
    float floorShare = max(strip.y - strip.x, 0.0) / p.spacing;

    float matte = l.across * ridgeFacing(l, v, arc) / (p.spacing * max(v.cosine, 1e-20))
        + floorShare * g.nl;
    float lobe = poulinFournierLobe(g, p, arc, l, v, floorShare);
    bool normalised = p.normalisation == POULIN_FOURNIER_NORMALISATION_NORMALISED;
    vec3 highlight = p.specularColor * slotFresnel(halfIncidence(d), p.fresnel) * lobe;
    return p.diffuseColor * matte
        + glossed(highlight, p.gloss, p.glossMode == POULIN_FOURNIER_GLOSS_MODE_LIMIT,
            normalised ? g.nl : 1.0);
}
