// SPDX-License-Identifier: MIT-0

vec3 fogged(Surface s, vec3 shaded, Fog p) {
    return mix(fogColor(p), shaded, fogShare(s.range, p));
}
