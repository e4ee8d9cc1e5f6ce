// SPDX-License-Identifier: MIT-0
#include "lib/sky_ray.glsl"

// Upright strips at even angles around the object, the first one in front on the right, and one
// strip overhead from front to back.
vec3 stripLightsEnvironment(SkyRay o, StripLightsEnvironment p) {
    float soft = 0.01 + 0.3 * p.softness;
    float around = azimuthOf(o.d);
    float height = elevationOf(o.d);
    float share = smoothstep(0.0, 0.02, p.stripWidth) * smoothstep(0.0, 0.02, p.stripHeight);
    float count = float(p.strips);
    if (count < 0.5) {
        share = 0.0;
    } else {
        float gap = 2.0 * PI / count;
        float turned = (around - 0.35 * gap) / gap;
        float across = abs(turned - floor(turned + 0.5)) * gap;
        float halfWidth = 0.5 * p.stripWidth;
        float halfHeight = 0.5 * p.stripHeight;
        float edge = min(soft, halfWidth + 1e-3);
        float up = abs(height - p.stripMiddle);
        share *= fallingStep(halfWidth - edge, halfWidth + edge, across) *
                 fallingStep(halfHeight - soft, halfHeight + soft, up);
    }
    float over = o.d.y > 0.0 ? 1.0 : 0.0;
    float aside = abs(o.d.x) / max(o.d.y, 1e-3);
    float along = abs(o.d.z) / max(o.d.y, 1e-3);
    float top = over * fallingStep(0.12 - min(soft, 0.12), 0.12 + soft, aside) *
                fallingStep(1.2 - soft, 1.2 + soft, along);
    return (p.darkColor + vec3(p.stripIntensity * share + p.topIntensity * top)) * p.tint *
           p.intensity;
}
