// SPDX-License-Identifier: MIT-0
// What a ray sees of the scene, found in the picture of what was drawn before the body: the ray is
// followed along its line in the picture until it goes behind what is solid there. M. McGuire and
// M. Mara, Efficient GPU Screen-Space Ray Tracing, JCGT 3(4), 2014, without their treatment of
// thickness: a place counts when depth is continuous there. Tiles of the picture before or behind
// all of which the ray passes are skipped (Y. Uludag, Hi-Z Screen-Space Cone-Traced Reflections,
// GPU Pro 5, 2014), so that it is looked for in short steps where it may meet something.

uniform sampler2D behindColor;
// 1 where nothing solid is. passes/behind_reach.frag has filled a level of it.
uniform sampler2D behindDepth;
uniform int behindLevel;

const int STEPS_IN_TILE = 8;
const int MAX_TILES = 256;
const int MAX_EDGES = 16;
const int BISECTIONS = 4;

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

// The picture is as large as its colours; the depths have a rim more, for whole tiles.
ivec2 pictureSize() {
    return textureSize(behindColor, 0);
}

float solidDepth(ivec2 texel) {
    return texelFetch(behindDepth, clamp(texel, ivec2(0), pictureSize() - 1), 0).r;
}

// The nearest and the farthest of what is solid in a tile, in clip space.
vec2 reachOfTile(ivec2 tile) {
    ivec2 texel = 2 * clamp(tile, ivec2(0), textureSize(behindDepth, behindLevel) / 2 - 1);
    return 2.0 * vec2(texelFetch(behindDepth, texel, behindLevel).r,
                     texelFetch(behindDepth, texel + ivec2(1, 0), behindLevel).r) -
        1.0;
}

// How much deeper than what is solid there a place of the picture lies; negative in front of it,
// and where nothing is.
float depthBehind(vec3 place) {
    float solid = solidDepth(ivec2((0.5 * place.xy + 0.5) * vec2(pictureSize())));
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
    vec2 at = (0.5 * place.xy + 0.5) * vec2(pictureSize());
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
// between them and not past the edge of one; `place` is where. `before` lies as far before them as a
// tile is wide: by how much the line nears the surface from there tells an edge from a slope.
bool goesThrough(vec3 before, vec3 low, vec3 high, out vec3 place) {
    float lowDepth = exactDepthBehind(low);
    float highDepth = exactDepthBehind(high);
    float gap = highDepth - min(lowDepth, exactDepthBehind(before));
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
bool meets(vec4 a, vec4 b, out vec3 place) {
    place = vec3(0.0);
    float share = shareInPicture(a, b);
    if (!(share > 0.0)) {
        return false;
    }
    vec4 end = mix(a, b, share);
    vec3 from = a.xyz / a.w;
    vec3 to = end.xyz / max(end.w, 1e-20);
    vec2 tilesPerUnit = 0.5 * vec2(pictureSize()) / float(2 << behindLevel);
    vec2 begin = (from.xy + 1.0) * tilesPerUnit;
    vec2 way = (to.xy - from.xy) * tilesPerUnit;
    vec2 perTile = 1.0 / max(abs(way), vec2(1e-6));
    float perLongTile = min(perTile.x, perTile.y);
    vec2 border = abs(floor(begin) + step(0.0, way) - begin) * perTile;
    ivec2 tile = ivec2(floor(begin));
    ivec2 onwards = ivec2(sign(way));
    vec3 last = from;
    vec3 next = from;
    bool isBehind = depthBehind(from) > 0.0;
    float enters = 0.0;
    float at = 0.0;
    int first = 0;
    // What goes behind something is looked at closely outside of the loops that find it: a processor
    // that computes many pixels at once takes both ways of every branch within them.
    for (int edge = 0; edge < MAX_EDGES && enters < 1.0; ++edge) {
        bool crosses = false;
        for (int i = 0; i < MAX_TILES && enters < 1.0 && !crosses; ++i) {
            float leaves = min(min(border.x, border.y), 1.0);
            vec2 reach = reachOfTile(tile);
            vec2 z = mix(vec2(from.z), vec2(to.z), vec2(enters, leaves));
            bool isInFront = max(z.x, z.y) <= reach.x;
            bool isAllBehind = min(z.x, z.y) > reach.y;
            float count = ceil((leaves - enters) / perLongTile * float(STEPS_IN_TILE));
            int steps = isAllBehind ? 1 : clamp(int(count), 1, STEPS_IN_TILE);
            if (isInFront) {
                isBehind = false;
                last = mix(from, to, leaves);
            }
            if (isInFront || (isAllBehind && isBehind)) {
                steps = 0;
            }
            for (int j = first; j < steps && !crosses; ++j) {
                at = mix(enters, leaves, (float(j) + 0.99) / float(steps));
                next = mix(from, to, at);
                bool wasBehind = isBehind;
                isBehind = depthBehind(next) > 0.0;
                crosses = isBehind && !wasBehind;
                last = crosses ? last : next;
                first = j + 1;
            }
            if (!crosses) {
                first = 0;
                enters = leaves;
                bool isAcross = border.x < border.y;
                tile += onwards * (isAcross ? ivec2(1, 0) : ivec2(0, 1));
                border += perTile * (isAcross ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
            }
        }
        if (crosses) {
            vec3 before = mix(from, to, max(at - perLongTile, 0.0));
            isBehind = exactDepthBehind(next) > 0.0;
            if (isBehind && goesThrough(before, last, next, place)) {
                return true;
            }
            last = next;
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
