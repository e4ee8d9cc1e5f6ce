// SPDX-License-Identifier: MIT-0
// Directions in which a surface looks for the light of a whole environment. A round draws one
// direction by each of four rules, and the density is the mean of theirs (the balance heuristic,
// Veach 1997, section 9.2).
#include "lib/directions.glsl"

const int RULE_TABLE = 0;  // where the environment is bright
const int RULE_COSINE = 1; // where a matte surface looks
const int RULE_HALF = 2;   // around the normal, for the half vector
const int RULE_MIRROR = 3; // around the mirror direction
const int RULES = 4;

// A lobe that was looked for takes the place of RULE_HALF, and RULE_MIRROR is either.

// Lobes of every width from this angle on are met: as many samples fall between 0.001 and 0.002 rad
// as between 0.1 and 0.2. Models draw no lobe that is narrower.
const float NARROWEST = 1e-4;
const float WIDEST = 0.5 * PI;

// Running shares of the environment's light, in red: along each row of directions, and, in the last
// row, of the rows. Green: the density of a place, which is 1 on average over the unit square.
uniform sampler2D environmentTable;

// The first of `count` entries of a row of the table whose running share is above u.
int shareAbove(int row, int count, float u) {
    int low = 0;
    int high = count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (u < texelFetch(environmentTable, ivec2(middle, row), 0).r) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return low;
}

// Where within an entry the share u lies, 0 .. 1.
float placeWithin(int entry, int row, float u) {
    float from = entry > 0 ? texelFetch(environmentTable, ivec2(entry - 1, row), 0).r : 0.0;
    float to = texelFetch(environmentTable, ivec2(entry, row), 0).r;
    return clamp((u - from) / max(to - from, 1e-20), 0.0, 1.0);
}

// A direction of the environment, by its brightness.
vec3 brightDirection(vec2 u) {
    ivec2 size = ivec2(environmentData[1].xy);
    int row = shareAbove(size.y, size.y, u.y);
    int column = shareAbove(row, size.x, u.x);
    vec2 within = vec2(placeWithin(column, row, u.x), placeWithin(row, size.y, u.y));
    return environmentDirectionAt((vec2(float(column), float(row)) + within) / vec2(size));
}

// Its density, per solid angle.
float brightDensity(vec3 d) {
    ivec2 size = ivec2(environmentData[1].xy);
    ivec2 place = min(ivec2(environmentPlace(d) * vec2(size)), size - 1);
    float density = texelFetch(environmentTable, max(place, ivec2(0)), 0).g;
    return density / (2.0 * PI * PI * max(length(vec2(d.x, d.z)), 1e-6));
}

// The share of the directions that fall into the disc of NARROWEST, where they are even; it makes
// the density continuous at its rim.
float narrowShare() {
    return 1.0 / (1.0 + 2.0 * log(WIDEST / NARROWEST));
}

// An angle from the middle of a lobe of unknown width.
float lobeAngle(float u) {
    float narrow = narrowShare();
    if (u < narrow) {
        return NARROWEST * sqrt(u / narrow);
    }
    return NARROWEST * exp(log(WIDEST / NARROWEST) * (u - narrow) / (1.0 - narrow));
}

// Its density, per solid angle.
float lobeDensity(float angle) {
    float narrow = narrowShare();
    if (angle < NARROWEST) {
        return narrow / (PI * NARROWEST * NARROWEST);
    }
    float line = (1.0 - narrow) / (angle * log(WIDEST / NARROWEST));
    return angle < WIDEST ? line / (2.0 * PI * sin(angle)) : 0.0;
}

vec3 aroundAxis(vec3 axis, vec3 t, vec3 b, float angle, float turn) {
    return cos(angle) * axis + sin(angle) * (cos(turn) * t + sin(turn) * b);
}

// Half vectors as in a lobe of Trowbridge and Reitz's form with a width along each of two tangents.
struct Lobe {
    vec3 t;
    vec3 b;
    vec2 width; // tangents of angles; 0 when no lobe was looked for
};

vec3 lobeHalfVector(Surface s, Lobe lobe, vec2 u) {
    float radius = sqrt(u.x / (1.0 - u.x));
    vec2 slope = lobe.width * radius * vec2(cos(2.0 * PI * u.y), sin(2.0 * PI * u.y));
    return normalize(s.n + slope.x * lobe.t + slope.y * lobe.b);
}

// Its density, per solid angle of h.
float lobeHalfDensity(Surface s, Lobe lobe, vec3 h) {
    float c = dot(h, s.n);
    if (!(c > 1e-4)) {
        return 0.0;
    }
    vec2 slope = vec2(dot(h, lobe.t), dot(h, lobe.b)) / (c * lobe.width);
    float fall = 1.0 + dot(slope, slope);
    return 1.0 / (PI * lobe.width.x * lobe.width.y * c * c * c * fall * fall);
}

vec3 mirrored(Surface s, vec3 h) {
    return 2.0 * dot(s.v, h) * h - s.v;
}

// For lobes of any width, around the mirror direction or for the half vector.
vec3 unknownDirection(Surface s, bool isMirror, vec2 u) {
    float turn = 2.0 * PI * u.y;
    if (!isMirror) {
        return mirrored(s, aroundAxis(s.n, s.t, s.b, lobeAngle(u.x), turn));
    }
    vec3 r = 2.0 * dot(s.n, s.v) * s.n - s.v;
    vec3 t = anyTangent(r);
    return aroundAxis(r, t, cross(r, t), lobeAngle(u.x), turn);
}

vec3 drawnDirection(Surface s, Lobe lobe, int rule, vec2 u) {
    bool hasLobe = lobe.width.x > 0.0;
    if (rule == RULE_TABLE) {
        return environmentOutside(brightDirection(u));
    }
    if (rule == RULE_COSINE) {
        float angle = atan(sqrt(u.x), sqrt(1.0 - u.x));
        return aroundAxis(s.n, s.t, s.b, angle, 2.0 * PI * u.y);
    }
    if (!hasLobe) {
        return unknownDirection(s, rule == RULE_MIRROR, u);
    }
    if (rule == RULE_HALF) {
        return mirrored(s, lobeHalfVector(s, lobe, u));
    }
    return unknownDirection(s, u.x < 0.5, vec2(fract(2.0 * u.x), u.y));
}

// Of all rules together, per solid angle.
float drawnDensity(Surface s, Lobe lobe, Directions d, vec3 l, vec3 inside) {
    float cosine = max(d.nl, 0.0) / PI;
    float halfAngle = atan(sqrt(d.sin2h), sqrt(d.cos2h));
    float perHalf = d.nH > 0.0 ? 1.0 / (4.0 * max(d.lh, 1e-6)) : 0.0;
    float unknown = perHalf * lobeDensity(halfAngle) +
                    lobeDensity(2.0 * asin(min(sqrt(0.5 * d.versineRv), 1.0)));
    if (lobe.width.x > 0.0) {
        vec3 h = safeNormalize(l + s.v, s.n);
        unknown = 0.5 * unknown + perHalf * lobeHalfDensity(s, lobe, h);
    }
    return (brightDensity(inside) + cosine + unknown) / float(RULES);
}
