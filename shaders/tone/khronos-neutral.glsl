// SPDX-License-Identifier: MIT-0

// Khronos PBR Neutral (2024): start F90 = 0.8 - 0.04 and desaturation 0.15. Below 0.08 the offset is
// m - 6.25 m^2, so nothing gets below 0.
vec3 khronosNeutralTone(vec3 light, KhronosNeutralTone p) {
    const float start = 0.8 - 0.04;
    const float desaturation = 0.15;
    float least = min(light.r, min(light.g, light.b));
    float offset = least < 0.08 ? least - 6.25 * least * least : 0.04;
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
