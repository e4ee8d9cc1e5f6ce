// SPDX-License-Identifier: MIT-0
#include "lib/picture_point.glsl"

// The threshold of Bayer's recursive matrix, 8 by 8, in the middle of its 64 steps.
float ditherBayer(ivec2 cell) {
    int x = cell.x & 7;
    int y = cell.y & 7;
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        int right = (x >> bit) & 1;
        int up = (y >> bit) & 1;
        int part = ((right ^ up) * 2 + up) << (2 * (2 - bit));
        rank += part;
    }
    return (float(rank) + 0.5) / 64.0;
}

// Turns and mirrors a square of Hilbert's curve whose last dot is `last`.
ivec2 ditherTurned(ivec2 cell, int right, int up, int last) {
    int one = 1;
    if (up == one) {
        return cell;
    }
    return right == one ? ivec2(last - cell.y, last - cell.x) : ivec2(cell.y, cell.x);
}

// The dot at a place along Hilbert's curve through 2048 by 2048 dots.
ivec2 ditherDot(int along) {
    int none = 0;
    ivec2 cell = ivec2(none, none);
    int left = along;
    for (int side = 1; side < 2048; side = side * 2) {
        int right = 1 & (left / 2);
        int up = 1 & (left ^ right);
        int last = side - 1;
        cell = ditherTurned(cell, right, up, last);
        cell.x += side * right;
        cell.y += side * up;
        int rest = left / 4;
        left = rest;
    }
    return cell;
}

// The place of a dot along the curve.
int ditherAlong(ivec2 dots) {
    int last = 2047;
    ivec2 cell = ivec2(dots.x & last, dots.y & last);
    int along = 0;
    for (int side = 1024; side > 0; side = side / 2) {
        int right = (cell.x & side) / side;
        int up = (cell.y & side) / side;
        int more = side * side * ((3 * right) ^ up);
        along += more;
        cell = ditherTurned(cell, right, up, last);
    }
    return along;
}

// Neighbours on the plane are mostly near to each other along the curve, where multiples of the golden
// ratio leave no gaps and no lumps.
float ditherBlue(ivec2 cell) {
    return pictureGolden(ditherAlong(cell));
}

float ditherWidth(PicturePoint at, DitherPass p) {
    return max(floor(p.dot * at.scale + 0.5), 1.0);
}

// What is to be shown in steps, each from 0 to 1.
vec3 ditherTone(PicturePoint at, ivec2 cell, DitherPass p) {
    float width = ditherWidth(at, p);
    vec3 color =
        pictureMean((vec2(float(cell.x), float(cell.y)) + vec2(0.5)) * width, 0.5 * width);
    vec3 tone = color;
    if (p.colors == DITHER_PASS_COLORS_INKS) {
        tone = vec3(0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b);
    }
    return clamp(vec3(0.18) + p.contrast * (tone - vec3(0.18)), vec3(0.0), vec3(1.0));
}

// The light of a step, which lie evenly by a power of 2.2.
float ditherStep(float number, float last) {
    return pow(clamp(number / last, 0.0, 1.0), 2.2);
}

// The step that a tone becomes above a threshold.
float ditherShown(float tone, float threshold, float last) {
    float below = clamp(floor(last * pow(tone, 1.0 / 2.2)), 0.0, last - 1.0);
    float dark = ditherStep(below, last);
    float light = ditherStep(below + 1.0, last);
    return tone - dark > threshold * (light - dark) ? light : dark;
}

// Along the curve, from the first dot of a run to this one, what a dot is off goes to the next one.
vec3 ditherDiffused(PicturePoint at, ivec2 cell, float last, DitherPass p) {
    int run = 64;
    int middle = 32;
    int few = 16;
    if (p.run == DITHER_PASS_RUN_SHORT) {
        run = few;
    } else if (p.run == DITHER_PASS_RUN_MIDDLE) {
        run = middle;
    }
    int end = ditherAlong(cell);
    int begin = end - (end & (run - 1));
    vec3 shown = vec3(0.0);
    vec3 off = vec3(0.5) * (pictureRandom(ivec2(begin, begin)) - 0.5) / last;
    for (int i = 0; i < run; ++i) {
        if (begin + i <= end) {
            ivec2 each = ditherDot(begin + i);
            vec3 wanted = ditherTone(at, each, p) + off;
            vec3 tone = clamp(wanted, vec3(0.0), vec3(1.0));
            shown = vec3(ditherShown(tone.r, 0.5, last), ditherShown(tone.g, 0.5, last),
                         ditherShown(tone.b, 0.5, last));
            off = wanted - shown;
        }
    }
    return shown;
}

vec3 ditherPass(PicturePoint at, DitherPass p) {
    float width = ditherWidth(at, p);
    ivec2 cell = ivec2(int(floor(at.pixel.x / width)), int(floor(at.pixel.y / width)));
    float last = float(p.steps) - 1.0;
    vec3 shown = vec3(0.0);
    if (p.pattern == DITHER_PASS_PATTERN_DIFFUSED) {
        shown = ditherDiffused(at, cell, last, p);
    } else {
        float threshold =
            p.pattern == DITHER_PASS_PATTERN_BAYER ? ditherBayer(cell) : ditherBlue(cell);
        vec3 tone = ditherTone(at, cell, p);
        shown = vec3(ditherShown(tone.r, threshold, last), ditherShown(tone.g, threshold, last),
                     ditherShown(tone.b, threshold, last));
    }
    return p.colors == DITHER_PASS_COLORS_INKS ? mix(p.dark, p.light, shown.r) : shown;
}
