// SPDX-License-Identifier: MIT-0
uniform int cubeFace;     // of a cube map: +x, -x, +y, -y, +z, -z
uniform float faceTexels; // its width

// The direction of a place on the face, in texels.
vec3 faceDirection(vec2 texel) {
    vec2 p = 2.0 * texel / faceTexels - 1.0;
    vec3 d = cubeFace == 0   ? vec3(1.0, -p.y, -p.x)
             : cubeFace == 1 ? vec3(-1.0, -p.y, p.x)
             : cubeFace == 2 ? vec3(p.x, 1.0, p.y)
             : cubeFace == 3 ? vec3(p.x, -1.0, -p.y)
             : cubeFace == 4 ? vec3(p.x, -p.y, 1.0)
                         : vec3(-p.x, -p.y, -1.0);
    return normalize(d);
}
