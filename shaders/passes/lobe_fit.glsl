// SPDX-License-Identifier: MIT-0
// Takes the reflectance of a model for one viewer apart: a matte part, which goes with n.l, and two
// lobes of von Mises' and Fisher's form, by expectation maximisation (Banerjee et al. 2005,
// Clustering on the Unit Hypersphere using von Mises-Fisher Distributions, JMLR 6). Nothing is lost
// in it: the three shares together are the albedo.
#include "passes/lobe_directions.glsl"

uniform sampler2D lobeSamples;

layout(location = 0) out vec4 storedMatte;    // its colour
layout(location = 1) out vec4 storedNarrow;   // the narrower lobe's colour, and log2 of its kappa
layout(location = 2) out vec4 storedWide;     // of the wider one
layout(location = 3) out vec4 storedShifts;   // the mean directions of both less the mirror one, x and z
layout(location = 4) out vec4 storedSideways; // and y, which is there only for a model with a grain

const int STEPS = 25;
const float MIN_KAPPA = 0.25;
const float MAX_KAPPA = 1e8;

struct FittedLobe {
    vec3 mean;
    float kappa;
    float share;
};

// Goes with the cosine to its mean direction, which leans to where more of the light comes from.
struct FittedMatte {
    vec3 mean;
    float share;
};

float versine(vec3 a, vec3 b) {
    vec3 d = a - b;
    return 0.5 * dot(d, d);
}

float lobeDensity(FittedLobe lobe, vec3 l) {
    float norm = lobe.kappa / (2.0 * PI * (1.0 - exp(-2.0 * lobe.kappa)));
    return lobe.share * norm * exp(-lobe.kappa * versine(lobe.mean, l));
}

// From 1 - R, R being the length of the mean of directions (Banerjee et al., equation 4.4).
float kappaFor(float missing) {
    float x = clamp(missing, 1e-9, 0.999);
    float length = 1.0 - x;
    return clamp(length * (3.0 - length * length) / (x * (2.0 - x)), MIN_KAPPA, MAX_KAPPA);
}

// The shares that the matte part and the two lobes have of a direction; the first where none of them
// reaches it, so that nothing is lost.
vec3 sharesAt(vec3 l, FittedMatte matte, FittedLobe narrowLobe, FittedLobe wideLobe) {
    vec3 densities = vec3(matte.share * max(dot(matte.mean, l), 0.0) / PI,
        lobeDensity(narrowLobe, l), lobeDensity(wideLobe, l));
    float sum = densities.x + densities.y + densities.z;
    return sum > 1e-30 ? densities / sum : vec3(1.0, 0.0, 0.0);
}

vec4 fetched(int entry, int i) {
    vec3 value = texelFetch(lobeSamples, ivec2(i, entry), 0).rgb;
    return vec4(value, value.r + value.g + value.b);
}

// What one step gathers of a lobe: the weights, the mean of l less the last mean direction, and the
// mean versine.
struct Gathered {
    float weight;
    vec3 shift;
    float versine;
};

void gather(inout Gathered sum, FittedLobe lobe, vec3 l, float weight) {
    sum.weight += weight;
    sum.shift += weight * (l - lobe.mean);
    sum.versine += weight * versine(lobe.mean, l);
}

FittedLobe fitted(Gathered sum, FittedLobe last, float all) {
    if (!(sum.weight > 1e-6 * all)) {
        return FittedLobe(last.mean, last.kappa, 0.0);
    }
    vec3 shift = sum.shift / sum.weight;
    float along = sum.versine / sum.weight;
    vec3 across = shift - dot(shift, last.mean) * last.mean;
    float missingSquared = 2.0 * along - along * along - dot(across, across); // 1 - R^2
    float missing = missingSquared / (1.0 + safeSqrt(1.0 - missingSquared));
    return FittedLobe(safeNormalize(last.mean + shift, last.mean), kappaFor(missing),
        sum.weight / all);
}

void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy);
    int entry = cell.x + FITTED_WIDTH * cell.y;
    vec3 v = tableViewer(entry);
    vec3 r = vec3(-v.x, 0.0, v.z);

    // Where the model is strong, and how much of it goes with n.l everywhere.
    float all = 0.0;
    float strong = 0.0;
    vec3 strongMean = vec3(0.0);
    vec3 allMean = vec3(0.0);
    float minimum = 1e30;
    for (int i = 0; i < LIGHTS; ++i) {
        vec4 light = tableLight(v, i);
        float m = fetched(entry, i).w;
        float f = m / light.w;
        all += m;
        allMean += m * light.xyz;
        strong += m * f;
        strongMean += m * f * light.xyz;
        if (light.z > 0.25) {
            minimum = min(minimum, f / light.z);
        }
    }
    storedMatte = vec4(0.0);
    storedNarrow = vec4(0.0);
    storedWide = vec4(0.0);
    storedShifts = vec4(0.0);
    storedSideways = vec4(0.0);
    if (!(all > 0.0)) {
        return;
    }
    // Lights on one side of the plane of incidence stand for those of both.
    vec3 both = AZIMUTHS == 1 ? vec3(1.0, 0.0, 1.0) : vec3(1.0);
    FittedLobe narrowLobe = FittedLobe(safeNormalize(both * strongMean, r), 1.0, 0.5);
    FittedLobe wideLobe = FittedLobe(safeNormalize(both * allMean, r), 2.0, 0.3);
    float strongSpread = 0.0;
    for (int i = 0; i < LIGHTS; ++i) {
        vec4 light = tableLight(v, i);
        float m = fetched(entry, i).w;
        strongSpread += m * (m / light.w) * versine(narrowLobe.mean, light.xyz);
    }
    narrowLobe.kappa = max(0.5 * kappaFor(strongSpread / max(strong, 1e-37)), 4.0);
    wideLobe.kappa = clamp(0.05 * narrowLobe.kappa, 1.0, 100.0);
    FittedMatte matte = FittedMatte(vec3(0.0, 0.0, 1.0), clamp(PI * minimum / all, 0.02, 0.98));
    narrowLobe.share = 0.6 * (1.0 - matte.share);
    wideLobe.share = 0.4 * (1.0 - matte.share);

    for (int step = 0; step < STEPS; ++step) {
        Gathered toNarrow = Gathered(0.0, vec3(0.0), 0.0);
        Gathered toWide = Gathered(0.0, vec3(0.0), 0.0);
        vec3 matteMean = vec3(0.0);
        float toMatte = 0.0;
        for (int i = 0; i < LIGHTS; ++i) {
            vec3 l = tableLight(v, i).xyz;
            float m = fetched(entry, i).w;
            vec3 shares = m * sharesAt(l, matte, narrowLobe, wideLobe);
            toMatte += shares.x;
            matteMean += shares.x * l;
            gather(toNarrow, narrowLobe, l, shares.y);
            gather(toWide, wideLobe, l, shares.z);
        }
        toNarrow.shift *= both;
        toWide.shift *= both;
        matteMean *= both;
        matteMean.z = max(matteMean.z, 0.3 * sqrt(dot(matteMean, matteMean)));
        matte = FittedMatte(safeNormalize(matteMean, vec3(0.0, 0.0, 1.0)), toMatte / all);
        narrowLobe = fitted(toNarrow, narrowLobe, all);
        wideLobe = fitted(toWide, wideLobe, all);
    }

    vec3 matteColor = vec3(0.0);
    vec3 narrowColor = vec3(0.0);
    vec3 wideColor = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 l = tableLight(v, i).xyz;
        vec3 value = fetched(entry, i).rgb;
        vec3 shares = sharesAt(l, matte, narrowLobe, wideLobe);
        matteColor += shares.x * value;
        narrowColor += shares.y * value;
        wideColor += shares.z * value;
    }
    storedMatte = vec4(matteColor, matte.mean.x / matte.mean.z);
    storedNarrow = vec4(narrowColor, log2(narrowLobe.kappa));
    storedWide = vec4(wideColor, log2(wideLobe.kappa));
    vec3 narrowShift = narrowLobe.mean - r;
    vec3 wideShift = wideLobe.mean - r;
    storedShifts = vec4(narrowShift.xz, wideShift.xz);
    storedSideways = vec4(narrowShift.y, wideShift.y, matte.mean.y / matte.mean.z, 0.0);
}
