// SPDX-License-Identifier: MIT-0
// A body: the ray leaves it through its farthest surface, which was drawn before (Wyman 2005). Each
// pixel of that holds the plane that touches the surface there.

// Its unit normal, away from the eye, and the normal times a place of it seen from the middle of the
// body; 0 where there is none.
uniform sampler2D refractionBack;
uniform vec4 refractionBody; // a ball around the body: its middle, its radius

const int STEPS_THROUGH = 16;
const int HALVINGS = 5;

vec4 backAt(ivec2 texel) {
    ivec2 size = textureSize(refractionBack, 0);
    bool isIn = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
    return isIn ? texelFetch(refractionBack, texel, 0) : vec4(0.0);
}

// Where in that picture a place of the world lies, in pixels.
vec2 backPlace(vec3 x) {
    vec4 clip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]) * vec4(x, 1.0);
    return (0.5 * clip.xy / max(clip.w, 1e-20) + 0.5) * vec2(textureSize(refractionBack, 0));
}

// Behind the eye and beside the body nothing is inside.
bool isInBody(vec3 x) {
    vec4 plane = backAt(ivec2(floor(backPlace(x))));
    return dot(plane.xyz, x - refractionBody.xyz) < plane.w;
}

// The plane at a place between pixels, of those around that have one.
vec4 backPlane(vec3 x) {
    vec2 texel = backPlace(x) - 0.5;
    ivec2 low = ivec2(floor(texel));
    vec2 share = texel - vec2(low);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 side = ivec2(i % 2, i / 2);
        vec2 weight = mix(1.0 - share, share, vec2(side));
        sum += weight.x * weight.y * backAt(low + side);
    }
    float size = length(sum.xyz);
    return size > 1e-6 ? sum / size : vec4(0.0);
}

// How far it is from x along d until the body ends.
float wayThrough(vec3 x, vec3 d) {
    vec3 m = x - refractionBody.xyz;
    float b = dot(m, d);
    float maxWay = safeSqrt(b * b - dot(m, m) + refractionBody.w * refractionBody.w) - b;
    float low = 0.0;
    float high = maxWay;
    for (int i = 1; i <= STEPS_THROUGH; ++i) {
        float way = maxWay * float(i) / float(STEPS_THROUGH);
        high = way;
        if (!isInBody(x + way * d)) {
            break;
        }
        low = way;
    }
    for (int i = 0; i < HALVINGS; ++i) {
        float way = 0.5 * (low + high);
        bool isIn = isInBody(x + way * d);
        low = isIn ? way : low;
        high = isIn ? high : way;
    }
    return max(0.5 * (low + high), 0.0);
}

// The same, once more on the plane that is there; `n` becomes its normal.
float wayToPlane(vec3 x, vec3 d, float way, OUT(vec3) n) {
    vec4 plane = backPlane(x + way * d);
    float along = dot(plane.xyz, d);
    n = along > 0.0 ? plane.xyz : d;
    float exact = (plane.w - dot(plane.xyz, x - refractionBody.xyz)) / max(along, 1e-6);
    bool isNear = abs(exact - way) < refractionBody.w / float(STEPS_THROUGH);
    return along > 0.05 && isNear ? max(exact, 0.0) : way;
}

Passage passageFrom(Surface s, Interface c, Refraction p) {
    vec3 inside = safeNormalize(refractedRay(c, p), -s.v);
    vec3 n;
    float way = wayThrough(s.x, inside);
    way = wayToPlane(s.x, inside, way, n);
    Passage w;
    w.way = wayToPlane(s.x, inside, way, n);
    w.x = s.x + w.way * inside;
    Interface leaving;
    leaving.l = -inside;
    leaving.n = -n;
    leaving.channel = c.channel;
    leaving.leaves = true;
    w.inner = inside - 2.0 * dot(inside, n) * n;
    w.leaving = safeNormalize(refractedRay(leaving, p), w.inner);
    w.kept = mirroredShare(leaving, p);
    return w;
}

vec3 lightThrough(Surface s, Passage w) {
    vec3 behind = seenBehind(s, w, dFdx(w.leaving), dFdy(w.leaving));
    vec3 inner = distantLight(w.inner, dFdx(w.inner), dFdy(w.inner));
    return mix(behind, inner, w.kept);
}
