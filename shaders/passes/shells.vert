// SPDX-License-Identifier: MIT-0
// The layer of a shell that an instance draws: 0 is the skin itself, then the outermost first, so
// that those below are hidden before they are shaded.
#include "passes/surface.vert"
#include "lib/strand.glsl"
#include "passes/object_axes.glsl"

out vec3 strandRoot;   // metres along the object's axes
out vec3 strandNormal; // of the surface there, along the same axes
out float shellHeight; // 0 on the skin, 1 on the outermost layer
out vec3 strandSlide;  // how far the roots that are seen move on the way to the layer below

// The strand around which a vertex is moved: the longest one.
Strand strandAt(vec3 n, float height) {
    Strand s;
    s.height = height;
    s.n = n;
    s.nl = 1.0;
    s.size = 0.0;
    s.shade = 0.0;
    s.phase = 0.0;
    return s;
}

// Where the layer is beside the skin, no farther from it than strands are long.
vec3 shellOffset(Shells p, float height) {
    vec3 offset = shellsOffset(strandAt(strandNormal, height), p);
    float range2 = dot(offset, offset);
    float longest = SHELLS_LENGTH(p);
    return range2 > longest * longest ? offset * (longest * inversesqrt(range2)) : offset;
}

void moveTo(vec3 place) {
    float behind = dot(worldNormal, toEye) < 0.0 ? viewData[5].x : 0.0;
    worldPosition = place;
    toEye = viewData[4].xyz - place;
    mat4 worldToClip = mat4(viewData[0], viewData[1], viewData[2], viewData[3]);
    gl_Position = worldToClip * vec4(place, 1.0);
    gl_Position.z += behind;
}

// Where the strands are rooted, in metres along the object's axes, however it is scaled.
void placeRoot(mat3 axes) {
    strandRoot = meshToAxes(axes) * position;
    strandNormal = worldNormal * axes;
}

// Behind a point of a layer the ray from the eye meets the layer below at another root: by how much
// that lies beside the first one, in metres along the object's axes. Seen from the side it would
// be far away; the limit is a cosine.
const float MIN_SLIDE_COSINE = 0.15;

vec3 slideBelow(Shells p, mat3 axes, float height) {
    vec3 rise = shellOffset(p, height) - shellOffset(p, height - 1.0 / float(SHELL_LAYERS));
    vec3 v = safeNormalize(toEye, worldNormal) * axes;
    float c = dot(v, strandNormal);
    vec3 slide = rise - v * (dot(rise, strandNormal) / max(c, MIN_SLIDE_COSINE));
    return c > 0.0 ? slide - dot(slide, strandNormal) * strandNormal : vec3(0.0);
}

void placeShell(Shells p) {
    int number = gl_InstanceID % (SHELL_LAYERS + 1);
    int layer = number == 0 ? 0 : SHELL_LAYERS + 1 - number;
    shellHeight = float(layer) / float(SHELL_LAYERS);
    mat3 axes = objectAxes();
    placeRoot(axes);
    strandSlide = vec3(0.0);
    if (layer > 0) {
        strandSlide = slideBelow(p, axes, shellHeight);
        moveTo(worldPosition + axes * shellOffset(p, shellHeight));
    }
    PLACE_STRAND(p);
}
