// SPDX-License-Identifier: MIT-0
#include "lib/lamp_share.glsl"
#include "lib/sky_ray.glsl"

// The share of a window that is seen in the direction d: its panes, two across and three up,
// without the bars between them. The window stands one metre away along the unit vector c.
float windowShare(vec3 d, vec3 c, float w, float h, float bars, float edge) {
    vec3 across = normalize(vec3(c.z, 0.0, -c.x));
    vec3 upward = cross(c, across);
    float facing = max(dot(d, c), 1e-3);
    float x = dot(d, across) / facing;
    float y = dot(d, upward) / facing;
    float soft = 0.004 + 0.5 * edge;
    float upright = smoothstep(bars - soft, bars + soft, abs(x));
    float level = smoothstep(bars - soft, bars + soft, abs(abs(y) - h / 3.0));
    float open = mix(1.0, upright * level, smoothstep(0.0, 0.01, bars));
    float size = smoothstep(0.0, 0.02, w) * smoothstep(0.0, 0.02, h); // of no size: none
    return size * lampShare(d, c, w, h, edge) * open;
}

// Walls between a light ceiling and the floor, two windows on the left and a doorway on the right.
vec3 windowRoomEnvironment(SkyRay o, WindowRoomEnvironment p) {
    float edge = 0.008 + 0.2 * p.softness;
    vec3 wall = smoothLerp(p.wallColor, p.ceilingColor, 0.45, 0.75, o.d.y);
    vec3 light = smoothLerp(p.floorColor, wall, -0.45, -0.3, o.d.y);

    vec3 near = vec3(-0.8452, 0.1690, 0.5071);
    vec3 far = vec3(-0.8452, 0.1690, -0.5071);
    float share = windowShare(o.d, near, p.windowWidth, p.windowHeight, p.bars, edge) +
                  windowShare(o.d, far, p.windowWidth, p.windowHeight, p.bars, edge);
    float sky = mix(0.25, 1.0, smoothstep(-0.15, 0.05, o.d.y));
    vec3 outside = vec3(0.86, 0.94, 1.0) * (p.windowIntensity * sky);
    light = lerp(light, outside, min(share, 1.0));

    vec3 doorway = vec3(0.9701, 0.0, -0.2425);
    vec3 warm = vec3(1.0, 0.87, 0.72) * p.doorIntensity;
    light = lerp(light, warm, lampShare(o.d, doorway, 0.3, 0.7, edge));
    return light * p.tint * p.intensity;
}
