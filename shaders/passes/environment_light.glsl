// SPDX-License-Identifier: MIT-0
// The light of a whole environment on a surface: the mean over directions of
//   radiance * model / (pi * density),
// whose expected value is the integral (1 / pi) of radiance * model over all directions. As
// directions are drawn by several rules the result is right for any model, and settles soon where
// one of the rules suits it. Where a frame has many rounds, the model's lobe is looked for first.
// Only a frame's mean is limited, to what a half float holds.
#include "passes/environment_directions.glsl"

const int ROUNDS_WITH_LOBE = 4;

// How much the model sends for a half vector, per its solid angle but for a factor.
float strengthAt(Surface s, vec3 h, Model p) {
    Directions d = directionsAt(s, normalize(2.0 * dot(s.v, h) * h - s.v), s.v);
    if (IS_DARK(d)) {
        return 0.0;
    }
    vec3 value = shadeModel(d, p);
    float maximum = max(max(value.r, value.g), value.b) * d.lh;
    return maximum > 0.0 ? min(maximum, 1e15) : 0.0;
}

// The width of the strongest lobe along one tangent: the mean angle, on a logarithmic scale, by the
// squared strength, times what makes it the width of a Gaussian or of Trowbridge and Reitz's lobe.
float widthAlong(Surface s, vec3 t, Model p) {
    vec3 side = dot(s.v, t) < 0.0 ? -t : t; // where the light stays above the horizon
    float sum = 0.0;
    float mean = 0.0;
    float angle = 0.001;
    for (int i = 0; i < 6; ++i) {
        float strength = strengthAt(s, cos(angle) * s.n + sin(angle) * side, p);
        float weight = strength * strength * angle;
        sum += weight;
        mean += weight * log(angle);
        angle *= 3.7;
    }
    return sum > 0.0 ? clamp(4.0 * exp(mean / sum), 5e-4, 0.7) : 0.7;
}

// Along the tangents of the surface or between them, where the widths differ more.
Lobe foundLobe(Surface s, Model p) {
    vec3 across = sqrt(0.5) * (s.t + s.b);
    vec3 along = sqrt(0.5) * (s.b - s.t);
    vec2 straight = vec2(widthAlong(s, s.t, p), widthAlong(s, s.b, p));
    vec2 oblique = vec2(widthAlong(s, across, p), widthAlong(s, along, p));
    bool isOblique = abs(log(oblique.x / oblique.y)) > abs(log(straight.x / straight.y));
    Lobe lobe;
    lobe.t = isOblique ? across : s.t;
    lobe.b = isOblique ? along : s.b;
    lobe.width = isOblique ? oblique : straight;
    return lobe;
}

// What one sample adds.
vec3 environmentArrived(Surface s, Lobe lobe, vec3 l, Environment e, Model p) {
    Directions d = directionsAt(s, l, s.v);
    vec3 inside = environmentInside(l);
    vec3 radiance = environmentRadiance(inside, e);
    float density = drawnDensity(s, lobe, d, l, inside);
    if (IS_DARK(d) || !(density > 0.0) || !(max(max(radiance.r, radiance.g), radiance.b) > 0.0)) {
        return vec3(0.0);
    }
    return radiance * (OPEN_TOWARDS(l, OPEN_EDGE) * max(shadeModel(d, p), vec3(0.0)) / (PI * density));
}

vec3 environmentLight(Surface s, Environment e, Model p) {
    int first = int(environmentData[0].z);
    int count = int(environmentData[1].z);
    // Less than a round begins with any of the rules: each is as likely as in a whole one.
    int begin = count < RULES
        ? int(float(RULES) * environmentPoint(uint(first), environmentSeed(uint(RULES))).x) : 0;
    Lobe lobe;
    lobe.t = s.t;
    lobe.b = s.b;
    lobe.width = vec2(0.0);
    if (count >= RULES * ROUNDS_WITH_LOBE) {
        lobe = foundLobe(s, p);
    }
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        int rule = (begin + i) % RULES;
        vec2 u = environmentPoint(uint(first + i / RULES), environmentSeed(uint(rule)));
        sum += environmentArrived(s, lobe, normalize(drawnDirection(s, lobe, rule, u)), e, p);
    }
    return sum / float(count);
}
