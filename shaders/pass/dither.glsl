// SPDX-License-Identifier: MIT-0
#include "lib/picture_point.glsl"

// The threshold of Bayer's recursive matrix, 8 by 8, in the middle of its 64 steps.
float ditherBayer(ivec2 dot2) {
    int x = dot2.x & 7;
    int y = dot2.y & 7;
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        int right = (x >> bit) & 1;
        int up = (y >> bit) & 1;
        rank += ((right ^ up) * 2 + up) << (2 * (2 - bit));
    }
    return (float(rank) + 0.5) / 64.0;
}

// White noise less the mean of its neighbours has few low frequencies. The mean of 24 of them with
// these weights is nearly normal with the deviation 0.108, from which follows how many dots have
// less: the threshold is even again.
float ditherBlue(ivec2 dot2) {
    float mean = 0.0;
    float weights = 0.0;
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            if (i != 0 || j != 0) {
                float weight = exp(-0.5 * float(i * i + j * j));
                mean += weight * pictureRandom(dot2 + ivec2(i, j));
                weights += weight;
            }
        }
    }
    float apart = pictureRandom(dot2) - mean / weights;
    float spread = 1.7320508 * 0.108;
    float below = clamp(apart + 0.5 - spread, 0.0, 1.0);
    float here = clamp(apart + 0.5, 0.0, 1.0);
    float above = clamp(apart + 0.5 + spread, 0.0, 1.0);
    return (below + 4.0 * here + above) / 6.0;
}

// The dot at a place along Hilbert's curve through 2048 by 2048 dots.
ivec2 ditherDot(int along) {
    int x = 0;
    int y = 0;
    int left = along;
    for (int side = 1; side < 2048; side = side * 2) {
        int right = 1 & (left / 2);
        int up = 1 & (left ^ right);
        if (up == 0) {
            if (right == 1) {
                x = side - 1 - x;
                y = side - 1 - y;
            }
            int swapped = x;
            x = y;
            y = swapped;
        }
        x += side * right;
        y += side * up;
        left = left / 4;
    }
    return ivec2(x, y);
}

// The place of a dot along the curve.
int ditherAlong(ivec2 dot2) {
    int x = dot2.x & 2047;
    int y = dot2.y & 2047;
    int along = 0;
    for (int side = 1024; side > 0; side = side / 2) {
        int right = (x & side) > 0 ? 1 : 0;
        int up = (y & side) > 0 ? 1 : 0;
        along += side * side * ((3 * right) ^ up);
        if (up == 0) {
            if (right == 1) {
                x = 2047 - x;
                y = 2047 - y;
            }
            int swapped = x;
            x = y;
            y = swapped;
        }
    }
    return along;
}

float ditherWidth(PicturePoint at, DitherPass p) {
    return max(floor(p.dot * at.scale + 0.5), 1.0);
}

// What is to be shown in steps, each from 0 to 1.
vec3 ditherTone(PicturePoint at, ivec2 dot2, DitherPass p) {
    float width = ditherWidth(at, p);
    vec3 color =
        pictureMean((vec2(float(dot2.x), float(dot2.y)) + vec2(0.5)) * width, 0.5 * width);
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

// Along the curve, from the last dot whose number is a multiple of 64 to this one, what a dot is off
// goes to the next one.
vec3 ditherDiffused(PicturePoint at, ivec2 dot2, float last, DitherPass p) {
    int end = ditherAlong(dot2);
    int begin = end - (end & 63);
    vec3 shown = vec3(0.0);
    vec3 off = vec3(0.5) * (pictureRandom(ivec2(begin, begin / 64)) - 0.5) / last;
    for (int i = 0; i < 64; ++i) {
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
    ivec2 dot2 = ivec2(int(floor(at.pixel.x / width)), int(floor(at.pixel.y / width)));
    float last = float(p.steps) - 1.0;
    vec3 shown = vec3(0.0);
    if (p.pattern == DITHER_PASS_PATTERN_DIFFUSED) {
        shown = ditherDiffused(at, dot2, last, p);
    } else {
        float threshold =
            p.pattern == DITHER_PASS_PATTERN_BAYER ? ditherBayer(dot2) : ditherBlue(dot2);
        vec3 tone = ditherTone(at, dot2, p);
        shown = vec3(ditherShown(tone.r, threshold, last), ditherShown(tone.g, threshold, last),
                     ditherShown(tone.b, threshold, last));
    }
    return p.colors == DITHER_PASS_COLORS_INKS ? mix(p.dark, p.light, shown.r) : shown;
}
