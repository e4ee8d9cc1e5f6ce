// SPDX-License-Identifier: MIT-0
// What a ray sees of the scene, found in the picture of what was drawn before the body: the ray is
// followed along its line in the picture until it goes behind what is solid there. M. McGuire and
// M. Mara, Efficient GPU Screen-Space Ray Tracing, JCGT 3(4), 2014, without their treatment of
// thickness: a place counts when depth is continuous there.

uniform sampler2D behindColor;
uniform sampler2D behindDepth; // 1 where nothing solid is

const int STEPS_BEHIND = 32;
const int BISECTIONS = 6;

vec4 placeInClip(vec4 x) {
    return mat4(viewData[0], viewData[1], viewData[2], viewData[3]) * x;
}

// How far the line from a (0) to b (1), both in clip space, stays in the picture; 0 when it begins
// outside. b may lie at infinity.
float shareInPicture(vec4 a, vec4 b) {
    vec4 begins = vec4(a.w + a.x, a.w - a.x, a.w + a.y, a.w - a.y);
    vec4 ends = vec4(b.w + b.x, b.w - b.x, b.w + b.y, b.w - b.y);
    float share = 1.0;
    for (int i = 0; i < 4; ++i) {
        if (!(begins[i] > 0.0)) {
            return 0.0;
        }
        if (ends[i] < 0.0) {
            share = min(share, begins[i] / (begins[i] - ends[i]));
        }
    }
    float near = a.w + a.z;
    float nearAtEnd = b.w + b.z;
    return nearAtEnd < 0.0 ? min(share, max(near, 0.0) / (near - nearAtEnd)) : share;
}

float solidDepth(ivec2 texel) {
    return texelFetch(behindDepth, clamp(texel, ivec2(0), textureSize(behindDepth, 0) - 1), 0).r;
}

// How much deeper than what is solid there a place of the picture lies; negative in front of it,
// and where nothing is.
float depthBehind(vec3 place) {
    float solid = solidDepth(ivec2((0.5 * place.xy + 0.5) * vec2(textureSize(behindDepth, 0))));
    return solid < 1.0 ? place.z - (2.0 * solid - 1.0) : -1.0;
}

// The slope of a surface from the differences to the neighbours on both sides, one of which may lie
// on something else.
float ownSlope(float before, float after) {
    return before * after > 0.0 ? (abs(before) < abs(after) ? before : after) : 0.0;
}

// The same between the middles of pixels: depth is linear in the picture on a plane, and on one that
// is seen at a grazing angle it changes more from pixel to pixel than a ray is away from it.
float exactDepthBehind(vec3 place) {
    vec2 at = (0.5 * place.xy + 0.5) * vec2(textureSize(behindDepth, 0));
    ivec2 texel = ivec2(at);
    float solid = solidDepth(texel);
    if (!(solid < 1.0)) {
        return -1.0;
    }
    vec2 slope = vec2(ownSlope(solid - solidDepth(texel - ivec2(1, 0)),
                          solidDepth(texel + ivec2(1, 0)) - solid),
        ownSlope(solid - solidDepth(texel - ivec2(0, 1)), solidDepth(texel + ivec2(0, 1)) - solid));
    solid += dot(slope, at - vec2(texel) - 0.5);
    return place.z - (2.0 * solid - 1.0);
}

// Whether the line from `low`, in front of something, to `high`, behind it, goes through a surface
// between them and not past the edge of one; `place` is where.
bool goesThrough(vec3 low, vec3 high, out vec3 place) {
    float lowDepth = exactDepthBehind(low);
    float highDepth = exactDepthBehind(high);
    float gap = highDepth - lowDepth;
    for (int i = 0; i < BISECTIONS; ++i) {
        vec3 middle = 0.5 * (low + high);
        float depth = exactDepthBehind(middle);
        if (depth > 0.0) {
            high = middle;
            highDepth = depth;
        } else {
            low = middle;
            lowDepth = depth;
        }
    }
    place = 0.5 * (low + high);
    return highDepth - lowDepth <= 0.25 * gap;
}

// Whether the line from a to b, both in clip space, meets something solid, and where.
bool meets(vec4 a, vec4 b, int steps, out vec3 place) {
    place = vec3(0.0);
    float share = shareInPicture(a, b);
    if (!(share > 0.0)) {
        return false;
    }
    vec4 end = mix(a, b, share);
    vec3 from = a.xyz / a.w;
    vec3 to = end.xyz / max(end.w, 1e-20);
    vec3 last = from;
    vec3 next = from;
    bool isBehind = depthBehind(from) > 0.0;
    for (int i = 1; i <= steps;) {
        bool entered = false;
        for (; i <= steps && !entered; ++i) {
            last = next;
            next = mix(from, to, float(i) / float(steps));
            bool wasBehind = isBehind;
            isBehind = depthBehind(next) > 0.0;
            entered = isBehind && !wasBehind;
        }
        if (entered) {
            isBehind = exactDepthBehind(next) > 0.0;
            if (isBehind && goesThrough(last, next, place)) {
                return true;
            }
        }
    }
    return false;
}

vec3 colorBehind(vec2 place) {
    ivec2 size = textureSize(behindColor, 0);
    vec2 texel = (0.5 * place + 0.5) * vec2(size) - 0.5;
    ivec2 low = clamp(ivec2(floor(texel)), ivec2(0), size - 1);
    ivec2 high = min(low + 1, size - 1);
    vec2 share = clamp(texel - vec2(low), vec2(0.0), vec2(1.0));
    vec3 below = mix(texelFetch(behindColor, low, 0).rgb,
        texelFetch(behindColor, ivec2(high.x, low.y), 0).rgb, share.x);
    vec3 above = mix(texelFetch(behindColor, ivec2(low.x, high.y), 0).rgb,
        texelFetch(behindColor, high, 0).rgb, share.x);
    return mix(below, above, share.y);
}
