// SPDX-License-Identifier: MIT-0
// What the engine hands to every surface program. The meaning of each vec4 is written into the
// program where it is read.
layout(std140) uniform ViewBlock {
    vec4 viewData[6]; // 0 .. 3: world to clip space, by columns; 4: the eye, and how
                      // wide a pixel of the target is in pixels of the picture;
                      // 5: how far back in clip space what faces away lies
};

layout(std140) uniform ObjectBlock {
    vec4 objectData[OBJECT_VEC4S];
};
