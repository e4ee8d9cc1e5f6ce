// SPDX-License-Identifier: MIT-0
// The albedo of a model by direction: what it sends to a viewer under a uniform white sky, as a
// share of the sky's own light. Nothing that reflects, without light of its own, reaches above 1.
// By the model's scale that is 1/pi times the integral of its values over the hemisphere of light.

layout(location = 0) out vec4 storedAlbedo;

// Rings around the mirror direction, where most lobes are: from its near neighbourhood on by
// factors, so that a lobe of any width meets several, then by equal steps.
const int NARROW_RINGS = 32;
const int WIDE_RINGS = 24;
const float NARROWEST = 1e-5;
const float WIDEST_NARROW = 0.3;

// The middle of a ring's polar angle (x) and the solid angle of all of it (y), by the midpoint.
vec2 ringAt(int i) {
    if (i < NARROW_RINGS) {
        float factor = log(WIDEST_NARROW / NARROWEST) / float(NARROW_RINGS);
        float angle = NARROWEST * exp((float(i) + 0.5) * factor);
        return vec2(angle, 2.0 * PI * sin(angle) * angle * factor);
    }
    float step = (PI - WIDEST_NARROW) / float(WIDE_RINGS);
    float angle = WIDEST_NARROW + (float(i - NARROW_RINGS) + 0.5) * step;
    return vec2(angle, 2.0 * PI * sin(angle) * step);
}

vec3 viewerAt(vec2 place) {
    float nv = place.x * place.x;
    float across = safeSqrt(1.0 - nv * nv);
    float azimuth = 2.0 * PI * place.y;
    return vec3(across * cos(azimuth), across * sin(azimuth), nv);
}

// What is not a number says nothing about the albedo; the pixels where it happens are shown.
vec3 valueFrom(vec3 l, vec3 v, Model p) {
    Directions d = directions(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), l, v);
    if (l.z <= 0.0 || IS_DARK(d)) {
        return vec3(0.0);
    }
    vec3 value = shadeModel(d, p);
    return vec3(value.r > 0.0 ? value.r : 0.0, value.g > 0.0 ? value.g : 0.0,
        value.b > 0.0 ? value.b : 0.0);
}

vec3 albedoTowards(vec3 v, Model p) {
    vec3 r = vec3(-v.x, -v.y, v.z);
    vec3 e = tangentAlong(r, vec3(1.0, 0.0, 0.0));
    vec3 f = cross(r, e);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < NARROW_RINGS + WIDE_RINGS; ++i) {
        vec2 ring = ringAt(i);
        for (int j = 0; j < SECTORS; ++j) {
            // Each ring is turned by the golden section, so that no streak falls between all.
            float turn = 2.0 * PI * (float(j) / float(SECTORS) + fract(0.618034 * float(i)));
            vec3 l = cos(ring.x) * r + sin(ring.x) * (cos(turn) * e + sin(turn) * f);
            sum += ring.y / float(SECTORS) * valueFrom(normalize(l), v, p);
        }
    }
    return sum / PI;
}

void storeAlbedo(Model p) {
    vec2 place = gl_FragCoord.xy / vec2(float(TABLE_WIDTH), float(TABLE_HEIGHT));
    storedAlbedo = vec4(albedoTowards(viewerAt(place), p), 1.0);
}
