// SPDX-License-Identifier: MIT-0
// What a fin needs to know of the ends of its edge. passes/shells.vert before it has the strands.

out mat4x3 finOffset; // from the skin in world space, after each quarter of the strands' length

void placeFin(Shells p) {
    mat3 axes = objectAxes();
    placeRoot(axes);
    shellHeight = 0.5;
    strandSlide = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        finOffset[i] = axes * shellOffset(p, 0.25 * float(i + 1));
    }
    PLACE_STRAND(p);
}
