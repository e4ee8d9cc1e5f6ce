// SPDX-License-Identifier: MIT-0

// Khronos PBR Neutral (2024): colours up to 0.8 keep their hue and saturation, what is brighter is
// compressed towards 1 and bleached a little. It removes the 0.04 that a dielectric reflects at
// normal incidence, so a base colour of x shows as x.
vec3 toneMapped(vec3 light) {
    const float start = 0.8 - 0.04;
    const float desaturation = 0.15;
    float minChannel = min(light.r, min(light.g, light.b));
    float offset = minChannel < 0.08 ? minChannel - 6.25 * minChannel * minChannel : 0.04;
    vec3 color = light - vec3(offset);
    float peak = max(color.r, max(color.g, color.b));
    if (peak < start) {
        return color;
    }
    float rest = 1.0 - start;
    float newPeak = 1.0 - rest * rest / (peak + rest - start);
    float bleach = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
    return mix(color * (newPeak / peak), vec3(newPeak), bleach);
}
