// SPDX-License-Identifier: MIT-0
// The directions of light that a model's reflectance is fitted from, for each viewer of the table of
// lobes. The axes are those of incidence: z the normal, x the way to the viewer along the surface.
// VIEWERS steps of the root of n.v by AZIMUTHS of the viewer about the normal; a model without a
// grain has one azimuth, and its light is the same on both sides of the plane of incidence.
#include "lib/directions.glsl"
#include "lib/math.glsl"

// Rings around the mirror direction: from its near neighbourhood on by factors, so that a lobe of
// any width meets several, then by equal steps.
const int NARROW_RINGS = 26;
const int WIDE_RINGS = 18;
const int LIGHTS = (NARROW_RINGS + WIDE_RINGS) * SECTORS;
const float NARROWEST_RING = 1e-4;
const float WIDEST_NARROW_RING = 0.3;

// The middle of a ring's polar angle (x) and the solid angle of all of it (y).
vec2 ringAt(int i) {
    if (i < NARROW_RINGS) {
        float factor = log(WIDEST_NARROW_RING / NARROWEST_RING) / float(NARROW_RINGS);
        float from = i > 0 ? NARROWEST_RING * exp(float(i) * factor) : 0.0;
        float to = NARROWEST_RING * exp(float(i + 1) * factor);
        float shareFrom = sin(0.5 * from);
        float shareTo = sin(0.5 * to);
        return vec2(sqrt(0.5 * (from * from + to * to)),
            4.0 * PI * (shareTo * shareTo - shareFrom * shareFrom));
    }
    float width = (PI - WIDEST_NARROW_RING) / float(WIDE_RINGS);
    float from = WIDEST_NARROW_RING + float(i - NARROW_RINGS) * width;
    return vec2(from + 0.5 * width, 2.0 * PI * (cos(from) - cos(from + width)));
}

vec3 tableViewer(int entry) {
    float root = max(float(entry % VIEWERS) / float(VIEWERS - 1), 0.02);
    float nv = root * root;
    return vec3(safeSqrt(1.0 - nv * nv), 0.0, nv);
}

// Of light `i` for a viewer in the plane of incidence, and, in w, the solid angle that it stands for.
vec4 tableLight(vec3 v, int i) {
    vec2 ring = ringAt(i / SECTORS);
    vec3 r = vec3(-v.x, 0.0, v.z);
    vec3 e = vec3(r.z, 0.0, -r.x);
    vec3 f = vec3(0.0, 1.0, 0.0);
    // Half a circle is the same seen from either end. Of whole ones each ring is turned by the golden
    // section, so that no streak falls between all.
    float turn = AZIMUTHS > 1
        ? 2.0 * PI * (float(i % SECTORS) + fract(0.618034 * float(i / SECTORS))) / float(SECTORS)
        : PI * (float(i % SECTORS) + 0.5) / float(SECTORS);
    vec3 l = cos(ring.x) * r + sin(ring.x) * (cos(turn) * e + sin(turn) * f);
    return vec4(normalize(l), ring.y / float(SECTORS));
}
