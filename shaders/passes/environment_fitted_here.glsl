// SPDX-License-Identifier: MIT-0
// The light of a whole environment on a surface whose reflectance is taken apart at each pixel, since
// images change it: a matte part, which is what the weakest of a few directions all over the hemisphere
// has of a cosine, and of the rest two lobes, by their moments. The wide one is seen in those same
// directions; the narrow one, near the mirror direction, over half vectors at angles from
// HALF_NARROWEST on by factors. Between FADES_FROM and FADES_TO from the mirror direction the one
// passes into the other (kappa: Banerjee et al. 2005, equation 4.4, as in lobe_fit.glsl).
#include "lib/directions.glsl"
#include "passes/reflectance_limits.glsl"

const int HALF_RINGS = 8;
const int HALF_SECTORS = 3;
const float HALF_NARROWEST = 5e-4;
const float HALF_FACTOR = 2.6;
// How far the mean of a third of a ring is from the ring's middle, for what its own middle is: a lobe
// that one half vector sees alone is as wide as what that one stands for.
const float HALF_MEAN = 0.805;

const float FADES_FROM = 0.4; // radians
const float FADES_TO = 0.8;

const int WIDE_RINGS = 3;
const int WIDE_SECTORS = 4;
const int WIDE_LIGHTS = WIDE_RINGS * WIDE_SECTORS;

// The share of the narrow lobe, by the versine of the angle from the mirror direction.
float narrowShare(float versine) {
    return 1.0 - smoothstep(FADES_FROM, FADES_TO, 2.0 * asin(min(sqrt(0.5 * versine), 1.0)));
}

// What one lobe gathers: its colour, the weights, the mean of l less the mirror direction, and the
// mean versine of the angle between them.
struct GatheredHere {
    vec3 color;
    float weight;
    vec3 shift;
    float versine;
};

vec3 seenBy(GatheredHere lobe, vec3 r) {
    if (!(lobe.weight > 0.0)) {
        return vec3(0.0);
    }
    vec3 shift = lobe.shift / lobe.weight;
    float along = lobe.versine / lobe.weight;
    vec3 across = shift - dot(shift, r) * r;
    float missingSquared = max(2.0 * along - along * along - dot(across, across), 0.0);
    float missing = clamp(missingSquared / (1.0 + safeSqrt(1.0 - missingSquared)), 1e-9, 0.9);
    float length = 1.0 - missing;
    float kappa = length * (3.0 - length * length) / (missing * (2.0 - missing));
    vec3 d = safeNormalize(r + shift, r);
    return lobe.color * OPEN_TOWARDS(d, OPEN_LOBE_EDGE(log2(kappa))) *
           environmentSeenBy(environmentInside(d), log2(kappa));
}

void gather(inout GatheredHere lobe, vec3 color, float mean, vec3 apart) {
    float weight = color.r + color.g + color.b;
    lobe.color += color;
    lobe.weight += weight;
    lobe.shift += weight * mean * apart;
    lobe.versine += weight * 0.5 * dot(apart, apart);
}

// Directions all over the hemisphere, each for as much of the cosine as the others: x along the way to
// the viewer, z the normal.
vec3 wideLight(int i) {
    int ring = i / WIDE_SECTORS;
    float sine2 = (float(ring) + 0.5) / float(WIDE_RINGS);
    float turn = 2.0 * PI * (float(i % WIDE_SECTORS) + 0.5 * float(ring % 2)) / float(WIDE_SECTORS);
    return vec3(sqrt(sine2) * cos(turn), sqrt(sine2) * sin(turn), sqrt(1.0 - sine2));
}

vec3 fittedLight(Surface s, Model p) {
    vec3 r = 2.0 * dot(s.n, s.v) * s.n - s.v;
    vec3 x = safeNormalize(s.v - dot(s.n, s.v) * s.n, s.t);
    vec3 y = cross(s.n, x);
    vec3 perCosine[WIDE_LIGHTS];
    vec3 matte = vec3(1e15);
    for (int i = 0; i < WIDE_LIGHTS; ++i) {
        vec3 w = wideLight(i);
        vec3 l = w.x * x + w.y * y + w.z * s.n;
        Directions d = directionsAt(s, l, s.v);
        perCosine[i] = IS_DARK(d) ? vec3(0.0) : reflectanceLimited(shadeModel(d, p)) / w.z;
        matte = min(matte, perCosine[i]);
    }
    GatheredHere wideLobe = GatheredHere(vec3(0.0), 0.0, vec3(0.0), 0.0);
    for (int i = 0; i < WIDE_LIGHTS; ++i) {
        vec3 w = wideLight(i);
        vec3 apart = w.x * x + w.y * y + w.z * s.n - r;
        float share = 1.0 - narrowShare(0.5 * dot(apart, apart));
        gather(wideLobe, (perCosine[i] - matte) * (share / float(WIDE_LIGHTS)), 1.0, apart);
    }
    GatheredHere narrowLobe = GatheredHere(vec3(0.0), 0.0, vec3(0.0), 0.0);
    float from = 0.0;
    float to = HALF_NARROWEST;
    for (int i = 0; i < HALF_RINGS; ++i) {
        float angle = sqrt(0.5 * (from * from + to * to));
        float area = 4.0 * PI * (sqr(sin(0.5 * to)) - sqr(sin(0.5 * from))) / float(HALF_SECTORS);
        for (int j = 0; j < HALF_SECTORS; ++j) {
            float turn = 2.0 * PI * (float(j) / float(HALF_SECTORS) + fract(0.618034 * float(i)));
            vec3 h = cos(angle) * s.n + sin(angle) * (cos(turn) * x + sin(turn) * y);
            float vh = dot(s.v, h);
            vec3 l = normalize(2.0 * vh * h - s.v);
            Directions d = directionsAt(s, l, s.v);
            if (vh > 0.0 && !IS_DARK(d)) {
                vec3 rest = max(reflectanceLimited(shadeModel(d, p)) - matte * max(d.nl, 0.0),
                    vec3(0.0));
                vec3 apart = l - r;
                float share = narrowShare(0.5 * dot(apart, apart));
                gather(narrowLobe, rest * (share * area * 4.0 * vh / PI), HALF_MEAN, apart);
            }
        }
        from = to;
        to *= HALF_FACTOR;
    }
    vec3 onMatte = environmentOnMatte(environmentInside(OPEN_MEAN(s.n)));
    return OPEN_SHARE * matte * onMatte + seenBy(wideLobe, r) + seenBy(narrowLobe, r);
}
