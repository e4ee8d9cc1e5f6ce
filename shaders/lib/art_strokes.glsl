// SPDX-License-Identifier: MIT-0
// The strokes of tonal art maps (E. Praun, H. Hoppe, M. Webb and A. Finkelstein, Real-Time
// Hatching, SIGGRAPH 2001): one square of paper, which repeats, with six tones at each level. A
// tone has all strokes of the lighter ones, a level all strokes of the coarser ones, and a stroke
// is as wide on all levels. Rows of strokes are numbered by the classes of lib/drawn_place.glsl, so
// that those of a class lie between those of the classes before.
#include "lib/drawn_place.glsl"

// How a hand draws the strokes.
struct ArtHand {
    float spacing; // px between the rows of the lightest tone
    float pen;     // px
    float wobble;  // 0 .. 1, how much strokes stray and bend
};

ArtHand artHand(float spacing, float pen, float wobble) {
    ArtHand hand;
    hand.spacing = max(spacing, 4.0);
    hand.pen = pen;
    hand.wobble = wobble;
    return hand;
}

// The rows of the lightest tone on the coarsest level, as a power of two; each level has twice as
// many as the one before.
const float ART_ROWS = 1.0;
const float ART_TONES = 6.0;
const float ART_LEVELS = 4.0;

// A number from 0 to below 1 of a stroke. The multiplier is odd; about 0.618 times 256 sets the
// first numbers evenly, as the golden ratio does.
float artRandom(float stroke, float multiplier, float shift) {
    float x = stroke * multiplier + shift;
    return (x - 256.0 * floor(x / 256.0)) / 256.0;
}

// The lightest tone that has the strokes of a class, `finer` of which lie behind the rows of the
// level: along 1, 2 and 5; across 3, 4 and 6.
float artFirstTone(float finer, bool isAcross) {
    float later = max(finer, 0.0);
    float last = max(later - 1.0, 0.0);
    return isAcross ? 3.0 + later + last : 1.0 + later + 2.0 * last;
}

// How much maps count that are laid on the surface from each axis, together 1: only those from the
// one that it faces, but that where another axis takes over, within 7 degrees, both count.
vec3 axisShares(DrawnPlace at) {
    vec3 a = at.n * at.n;
    float nearly = max(max(a.x, a.y), a.z) - 0.25;
    vec3 above = vec3(max(a.x - nearly, 0.0), max(a.y - nearly, 0.0), max(a.z - nearly, 0.0));
    above = above * above;
    return above * (1.0 / (above.x + above.y + above.z));
}

// The dots along a side of a level's map; the last one is the first one of the next map.
float artDots(float level) {
    return exp2(5.0 + level);
}

// The stroke of class `number` beside which a place of the paper lies, `along` and `aside` in dots
// of its level: those of whole numbers are exact.
vec2 artStroke(float along, float aside, float number, float set, float level, ArtHand hand) {
    float side = artDots(level) - 1.0;
    float pixels = exp2(ART_ROWS + level) * hand.spacing / side;
    float rows = exp2(max(number - 1.0, 0.0));
    float reach = number < 0.5 ? 0.5 : 0.5 / rows;
    float row = number < 0.5 ? floor(aside / side + 0.5) : floor(aside / side * rows);
    float inClass = number < 0.5 ? 0.0 : rows + row - rows * floor(row / rows);
    float stroke = inClass + set;
    float middle = side * (number < 0.5 ? row : (row + 0.5) / rows);
    float stray = hand.wobble * exp2(-max(number, 1.0)) * side;
    float off = along / side - artRandom(stroke, 159.0, 31.0);
    off = off - floor(off + 0.5);
    float bow = (artRandom(stroke, 75.0, 151.0) - 0.5) * (4.0 * off * off - 0.33);
    float from = aside - middle;
    float away = from - stray * (0.5 * (artRandom(stroke, 203.0, 113.0) - 0.5) + 0.6 * bow);
    // A pen is set down and lifted.
    float toEnd = 0.26 + 0.2 * artRandom(stroke, 109.0, 77.0);
    float pressed = clamp((toEnd - abs(off)) / 0.13, 0.0, 1.0);
    float width = hand.pen * (0.75 + 0.5 * artRandom(stroke, 61.0, 5.0)) *
        pressed * (2.0 - pressed);
    float inside = clamp(2.0 * (reach * side - abs(from)) * pixels, 0.0, 1.0);
    vec2 mark = lineMark(min(width, 0.75 * hand.spacing), abs(away) * pixels);
    return faded(mark, inside, 1.0 - inside);
}

// What three tones have of ink and of bare paper.
struct ArtTones {
    vec3 ink;
    vec3 bare;
};

// A stroke over those of the tones that have it.
ArtTones artOver(ArtTones drawn, vec2 mark, vec3 has) {
    ArtTones over;
    over.ink = drawn.ink + drawn.bare * has * mark.x;
    over.bare = drawn.bare * (vec3(1.0) - has * (1.0 - mark.y));
    return over;
}

// Which of the tones from `first` on have strokes of a class.
vec3 artHas(float first, float stroke) {
    return vec3(first > stroke - 0.5 ? 1.0 : 0.0, first > stroke - 1.5 ? 1.0 : 0.0,
        first > stroke - 2.5 ? 1.0 : 0.0);
}

// The tones `first` and the next two at a place of the paper, in dots. The tone 0 has no strokes.
ArtTones artTones(vec2 place, float level, float first, ArtHand hand) {
    ArtTones drawn;
    drawn.ink = vec3(0.0);
    drawn.bare = vec3(1.0);
    for (int i = 0; i < 7; ++i) {
        float number = float(i);
        float finer = number - (ART_ROWS + level);
        vec3 along = artHas(first, artFirstTone(finer, false));
        vec3 across = artHas(first, artFirstTone(finer, true));
        if (finer < 2.5 && along.z > 0.5) {
            drawn = artOver(drawn, artStroke(place.x, place.y, number, 0.0, level, hand), along);
        }
        if (finer < 2.5 && across.z > 0.5) {
            drawn = artOver(drawn, artStroke(place.y, place.x, number, 97.0, level, hand), across);
        }
    }
    return drawn;
}

// Where the maps lie in one table of 513 x 513 entries, side by side: level 3 has 256 x 256 of
// them, each coarser one half as many along a side, once for the tones 1 to 3 and once for 4 to 6.
const float ART_TABLE = 512.0;

// The first entry of a level's lighter map; the darker one lies right of it.
vec2 artCorner(float level) {
    float x = level > 1.5 ? 0.0 : (level > 0.5 ? 256.0 : 384.0);
    return vec2(x, level > 2.5 ? 0.0 : 256.0);
}

// Where in the table a place of the paper lies, 0 .. 1.
vec2 artTablePlace(vec2 place, float level, bool isDark) {
    vec2 corner = artCorner(level);
    float shift = isDark ? artDots(level) : 0.0;
    return vec2(corner.x + shift + place.x, corner.y + place.y) * (1.0 / ART_TABLE);
}

// The ink of three tones at an entry of the table.
vec3 artEntry(vec2 x, ArtHand hand) {
    float column = floor(x.x * ART_TABLE + 0.5);
    float row = floor(x.y * ART_TABLE + 0.5);
    float level = row < 255.5 ? 3.0 : (column < 255.5 ? 2.0 : (column < 383.5 ? 1.0 : 0.0));
    float dots = artDots(level);
    vec2 corner = artCorner(level);
    vec2 cell = vec2(column - corner.x, row - corner.y);
    bool isDark = cell.x > dots - 0.5;
    cell.x -= isDark ? dots : 0.0;
    if (cell.x > dots - 0.5 || cell.y > dots - 0.5) {
        return vec3(0.0);
    }
    return artTones(cell, level, isDark ? 4.0 : 1.0, hand).ink;
}
