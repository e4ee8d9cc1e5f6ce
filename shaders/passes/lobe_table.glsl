// SPDX-License-Identifier: MIT-0
// The table of lobes that surfaces read, from what was fitted to a few viewers: so many steps from each
// to the next that the nearest entry serves, which a software driver finds in half the time of a mean.

uniform sampler2DArray fittedLobes; // by lobe_fit.glsl

layout(location = 0) out vec4 storedMatte;
layout(location = 1) out vec4 storedNarrow;
layout(location = 2) out vec4 storedWide;
layout(location = 3) out vec4 storedShifts;
layout(location = 4) out vec4 storedSideways;

vec4 fittedEntry(int layer, ivec2 viewer) {
    int entry = viewer.x + VIEWERS * viewer.y;
    return texelFetch(fittedLobes, ivec3(entry % FITTED_WIDTH, entry / FITTED_WIDTH, layer), 0);
}

vec4 betweenViewers(int layer, ivec2 cell) {
    ivec2 low = cell / TABLE_STEPS;
    ivec2 high = ivec2(min(low.x + 1, VIEWERS - 1), (low.y + 1) % AZIMUTHS);
    vec2 place = vec2(cell - low * TABLE_STEPS) / float(TABLE_STEPS);
    return mix(mix(fittedEntry(layer, low), fittedEntry(layer, ivec2(high.x, low.y)), place.x),
        mix(fittedEntry(layer, ivec2(low.x, high.y)), fittedEntry(layer, high), place.x), place.y);
}

void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy);
    storedMatte = betweenViewers(0, cell);
    storedNarrow = betweenViewers(1, cell);
    storedWide = betweenViewers(2, cell);
    storedShifts = betweenViewers(3, cell);
    storedSideways = AZIMUTHS > 1 ? betweenViewers(4, cell) : vec4(0.0);
}
