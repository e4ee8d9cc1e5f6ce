// SPDX-License-Identifier: MIT-0
// Where a pass over the picture works, and what is seen there.

struct PicturePoint {
    vec2 pixel;  // of the picture, from its lower left corner; centres of pixels are at halves
    vec2 size;   // of the picture, in pixels
    float scale; // pixels per unit: the picture is 512 units high
};

struct PictureSurface {
    float depth;  // metres from the eye's plane; 1e30 where nothing is
    vec3 normal;  // unit, x to the right, y up, z to the eye; 0 where nothing is
    float number; // of the object, from 1 on; 0 where nothing is
};
