// SPDX-License-Identifier: MIT-0
#include "lib/art_strokes.glsl"
#include "lib/drawn_curvature.glsl"

vec3 tonalArtMapsMapsEntry(vec2 x, TonalArtMaps p) {
    return artEntry(x, artHand(p.spacing, p.penWidth, p.wobble));
}

// The ink of a whole tone from 0 to 6, read from its map. `place` is in dots.
float artToneInk(vec2 place, float level, float tone, TonalArtMaps p) {
    bool isDark = tone > 3.5;
    vec3 inks = tonalArtMapsMaps(artTablePlace(place, level, isDark), p);
    float number = isDark ? tone - 3.0 : tone;
    return tone < 0.5 ? 0.0 : (number < 1.5 ? inks.x : (number < 2.5 ? inks.y : inks.z));
}

// The ink between two tones at a place, in sides of the square of paper. Beyond the finest level
// squares of half the side, a quarter .. have that level again, so that strokes do not grow.
vec2 artLevelInk(vec2 place, float scale, float dark, TonalArtMaps p) {
    float level = min(scale, ART_LEVELS - 1.0);
    vec2 paper = exp2(scale - level) * place + p.mapShift;
    float tone = ART_TONES * dark;
    float lower = min(floor(tone), ART_TONES - 1.0);
    float share = tone - lower;
    float side = artDots(level) - 1.0;
    if (p.strokes == TONAL_ART_MAPS_STROKES_EXACT) {
        // To the nearest whole number: a place just below one keeps its digits.
        vec2 near = side * (paper - floor(paper + vec2(0.5)));
        ArtTones drawn = artTones(near, level, lower, artHand(p.spacing, p.penWidth, p.wobble));
        float bare = (lower + 1.0 - tone) * drawn.bare.x + share * drawn.bare.y;
        return vec2((lower + 1.0 - tone) * drawn.ink.x + share * drawn.ink.y, bare);
    }
    vec2 dots = side * (paper - floor(paper));
    float ink = (lower + 1.0 - tone) * artToneInk(dots, level, lower, p) +
        share * artToneInk(dots, level, lower + 1.0, p);
    return vec2(ink, max(1.0 - ink, 0.0));
}

// The maps laid along a direction, between two scales. Below the coarsest one strokes cannot be
// told apart, and an even tone takes their place.
vec2 artMarks(DrawnPlace at, vec3 along, vec3 across, float dark, TonalArtMaps p) {
    float size = max(p.mapSize, 1e-6);
    float apart = passedByPixel(at, across) * max(p.spacing, 4.0) * exp2(ART_ROWS);
    float wanted = log2(clamp(size / apart, exp2(-MAX_SCALE), exp2(MAX_SCALE)));
    float scale = max(wanted, 0.0);
    float lower = floor(scale);
    float next = scale - lower;
    vec2 place = vec2(dot(at.x, along) / size, dot(at.x, across) / size);
    vec2 drawn = (1.0 - next) * artLevelInk(place, lower, dark, p) +
        next * artLevelInk(place, lower + 1.0, dark, p);
    float cells = (abs(at.x.x) + abs(at.x.y) + abs(at.x.z)) / size * exp2(ART_ROWS + scale);
    float clear = clamp(2.0 - cells / 131072.0, 0.0, 1.0) * clamp(1.0 + 0.5 * wanted, 0.0, 1.0);
    return clearMarks(drawn, clear, vec2(0.5 * dark, 1.0 - 0.5 * dark));
}

// The tone of one of the maps that have a place in common: two halves together are about as dark
// as the whole.
float artShared(float dark, float share) {
    return dark * share * (1.6 - 0.6 * share);
}

// How much a map counts whose strokes are turned away from where they should run, by the sine:
// none from 15 degrees on.
float artTurned(float sine) {
    return max(0.0669873 - sine * sine, 0.0);
}

// Maps in eight directions, laid on from one axis of the object. Where a direction goes over into
// the next one both share the tone, so that strokes of one leave as those of the other come.
vec2 artFrom(DrawnPlace at, vec3 right, vec3 up, vec3 way, float dark, TonalArtMaps p) {
    float x = dot(way, right);
    float y = dot(way, up);
    float size = max(sqrt(x * x + y * y), 1e-6);
    x = x / size;
    y = y / size;
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        float angle = 0.125 * PI * float(i);
        sum += artTurned(y * cos(angle) - x * sin(angle));
    }
    vec2 drawn = vec2(0.0, 1.0);
    for (int i = 0; i < 8; ++i) {
        float angle = 0.125 * PI * float(i);
        float c = cos(angle);
        float s = sin(angle);
        float share = artTurned(y * c - x * s) / max(sum, 1e-6);
        if (share > 0.0) {
            vec3 along = c * right + s * up;
            vec3 across = c * up - s * right;
            drawn = overInk(drawn, artMarks(at, along, across, artShared(dark, share), p));
        }
    }
    return drawn;
}

vec3 tonalArtMaps(Directions d, TonalArtMaps p) {
    DrawnPlace at = drawnAt(p.place, p.placeNormal, p.placeView, p.placePixel);
    float dark = tones(d, p.toneDark, p.toneLight).x;
    vec3 cut = unitVector(cross(unitVector(p.lineDirection, vec3(0.0, 1.0, 0.0)), at.n),
        anyTangent(at.n));
    // What bends by less than a twentieth within a map counts as flat.
    vec3 way = bendingWay(drawnBend(p.placeCurvature, p.placeCurvatureMixed), at.n, cut,
        0.05 / max(p.mapSize, 1e-6), p.follow);
    vec3 x = vec3(1.0, 0.0, 0.0);
    vec3 y = vec3(0.0, 1.0, 0.0);
    vec3 z = vec3(0.0, 0.0, 1.0);
    vec3 shares = axisShares(at);
    vec2 drawn = vec2(0.0, 1.0);
    if (shares.x > 0.0) {
        drawn = artFrom(at, z, y, way, artShared(dark, shares.x), p);
    }
    if (shares.y > 0.0) {
        drawn = overInk(drawn, artFrom(at, x, z, way, artShared(dark, shares.y), p));
    }
    if (shares.z > 0.0) {
        drawn = overInk(drawn, artFrom(at, x, y, way, artShared(dark, shares.z), p));
    }
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
