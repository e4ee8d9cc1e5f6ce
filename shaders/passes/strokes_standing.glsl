// SPDX-License-Identifier: MIT-0
// Marks that stand on the surface and hide those behind them: a sample of a pixel has ink or none.

// A number of the pixel and the mark that differs from its neighbours' (after J. Jimenez, Next
// Generation Post Processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014).
float markNoise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))) +
        markRandom.y);
}

vec3 markInk(Surface s, vec3 light) {
    MarkPoint m = markHere(light);
    float cover = markShape * clamp(strokesOpacity(m, strokes), 0.0, 1.0);
    float noise = markNoise();
    int kept = 0;
    for (int i = 0; i < 16; ++i) {
        kept |= fract(noise + 0.618034 * float(i)) < cover ? 1 << i : 0;
    }
    kept &= gl_SampleMaskIn[0];
    gl_SampleMask[0] = kept;
    if (kept == 0) {
        discard;
    }
    markAlpha = 1.0;
    return max(strokesInk(m, strokes), vec3(0.0));
}
