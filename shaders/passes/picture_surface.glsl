// SPDX-License-Identifier: MIT-0
// What surface a pixel of the picture shows, at its centre.

uniform sampler2D normalImage;
uniform sampler2D depthImage; // y: the number of the object

PictureSurface pictureSurface(vec2 pixel) {
    ivec2 last = textureSize(depthImage, 0) - ivec2(1);
    ivec2 texel = clamp(ivec2(floor(pixel)), ivec2(0), last);
    vec2 found = texelFetch(depthImage, texel, 0).xy;
    PictureSurface s;
    s.depth = found.x;
    s.normal = texelFetch(normalImage, texel, 0).xyz;
    s.number = found.y;
    return s;
}
