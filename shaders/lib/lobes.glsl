// SPDX-License-Identifier: MIT-0
// Highlights that are functions of one angle, 1 in their middle.
#include "lib/elementary.glsl"

// (n.h)^e, e >= 0, from sin2h : cos2h, the squared sine and cosine of the angle between n and h,
// and the sign of nH = n.(l + v); 0 where n.h <= 0, also for e = 0. J. F. Blinn, Models of Light
// Reflection for Computer Synthesized Pictures, SIGGRAPH 1977.
float blinnLobe(float sin2h, float cos2h, float nH, float e) {
    float lobe = powSC(sin2h, cos2h, e);
    return nH > 0.0 ? lobe : 0.0;
}

// t / (m - m t + t), t = r.v, m >= 0; 0 where t <= 0. Written as t / (t + m (1 - t)), which only
// adds positive terms. C. Schlick, A Fast Alternative to Phong's Specular Model, Graphics Gems IV,
// 1994.
float schlickLobe(float versineRv, float rv, float m) {
    return rv > 0.0 ? rv / (rv + m * versineRv) : 0.0;
}

// The factor pi (e + 2) / (2 pi) that makes the integral of (r.v)^e (n.l) / pi one when the light
// is at the normal. R. Lewis, Making Shaders More Physically Plausible, CGF 13(2), 1994.
float phongNormalisation(float e) {
    return 0.5 * (e + 2.0);
}

// The same for (n.h)^e: pi (e + 2)(e + 4) / (8 pi (2^(-e/2) + e)). Exact; the common (e + 8)/8 is
// up to 7.5 % above it (near e = 8). e >= 0.
float blinnNormalisation(float e) {
    return (e + 2.0) * (e + 4.0) / (8.0 * (exp2(-0.5 * e) + e));
}
