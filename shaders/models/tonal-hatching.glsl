// SPDX-License-Identifier: MIT-0
#include "lib/drawn_place.glsl"

// The darkness from which on the rows of a depth are drawn: those of the first set before those of
// the second, each halving later than the last. Six tones: 0, 1/6 and 4/6; 2/6, 3/6 and 5/6.
float hatchingOrder(float depth, bool isSecond) {
    float early = min(depth, 1.0);
    float late = clamp(depth - 1.0, 0.0, 1.0);
    float beyond = max(depth - 2.0, 0.0);
    return (isSecond ? 2.0 + early + 2.0 * late : early + 3.0 * late) / 6.0 + beyond;
}

// One set of parallel strokes, where planes across `way` cut the surface: the ink of each class of
// rows by its tone.
vec2 hatchingSet(DrawnPlace at, vec3 way, bool isSecond, float dark, TonalHatching p) {
    float passed = passedByPixel(at, way);
    DrawnScale s = drawnScale(passed * max(p.spacing, 2.0));
    vec3 across = anyTangent(way);
    float row = (dot(at.x, way)) * s.cells +
        0.35 * p.wobble * drawnWave(dot(at.x, across) + 0.37 * dot(at.x, cross(way, across)), s);
    float size = 1.0 / (passed * s.cells);
    float clear = clearOfPlanes(at, way);
    vec2 drawn = vec2(0.0, 1.0);
    for (int i = 0; i < 4; ++i) {
        float number = float(i);
        float order = hatchingOrder(classDepth(number, s.next), isSecond);
        float share = clamp(6.0 * (dark - order), 0.0, 1.0);
        if (share > 0.0) {
            float pressed = p.penWidth * (0.75 + 0.5 * p.pressure * (dark - 0.5));
            pressed = pressed * share * (2.0 - share);
            vec2 line = lineMark(min(pressed, 0.75 * size), size * offClass(row, number));
            drawn = overInk(drawn, faded(line, clear, 1.0 - clear));
        }
    }
    return clearMarks(drawn, drawnClear(at, s), vec2(0.5 * dark, 1.0 - 0.5 * dark));
}

// Strokes that are nested over tones and over scales, as in tonal art maps (E. Praun, H. Hoppe, M.
// Webb and A. Finkelstein, Real-Time Hatching, SIGGRAPH 2001), worked out in place of stored: a
// tone has the strokes of all lighter ones, a scale those of all coarser ones.
vec3 tonalHatching(Directions d, TonalHatching p) {
    DrawnPlace at = drawnAt(p.place, p.placeNormal, p.placeView, p.placePixel);
    float dark = tones(d, p.toneDark, p.toneLight).x;
    vec3 first = unitVector(p.lineDirection, vec3(0.0, 1.0, 0.0));
    vec3 second = unitVector(p.crossDirection, vec3(1.0, 0.0, 0.0));
    vec2 drawn = overInk(hatchingSet(at, first, false, dark, p),
        hatchingSet(at, second, true, dark, p));
    return drawn.y * p.diffuseColor + drawn.x * p.inkColor;
}
