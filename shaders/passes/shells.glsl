// SPDX-License-Identifier: MIT-0
// Which strand a point of a shell or a fin shows, if any. Strands stand in the cells of a square lattice
// across that axis of the object which the surface faces most, one in each at a random place, so
// they are spread evenly on any shape and stay where they are.
#include "passes/surface.glsl"
#include "lib/strand.glsl"

in vec3 strandRoot;
in vec3 strandNormal;
in float shellHeight;
in vec3 strandSlide;

// Beyond so many cells a lattice has no whole numbers that a float can tell apart.
const float MAX_CELL = 1e6;

Shells shells; // of this point, set at the beginning of main
Strand strand;

bool isSkin() {
    return !IS_FIN && shellHeight < 0.5 / float(SHELL_LAYERS);
}

// Three random numbers of 32 bits from three whole ones (M. Jarzynski and M. Olano, Hash Functions
// for GPU Rendering, JCGT 9(3), 2020, pcg3d).
uvec3 cellBits(ivec3 cell) {
    uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
    for (int round = 0; round < 2; ++round) {
        v.x += v.y * v.z;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        v ^= round == 0 ? v >> 16u : uvec3(0u);
    }
    return v;
}

// So far a ray goes at most, since cells beyond are not looked at.
const float MAX_WAY = 0.75;

const float PER_HALF = 1.0 / 65536.0;

// The surface as the lattice sees it.
struct Lattice {
    vec2 place;  // in cells
    vec2 way;    // on which the ray from the eye goes over it down to the next layer
    vec2 slope;  // of the surface, which is how far it rises over the lattice
    int face;    // which of six ways the surface faces
    float pixel; // how wide a pixel is, in cells
};

Lattice latticeAt(float density) {
    vec3 x = strandRoot * density;
    vec3 a = abs(strandNormal);
    bool isX = a.x >= a.y && a.x >= a.z;
    bool isY = !isX && a.y >= a.z;
    vec3 turned = isX ? x.yzx : isY ? x.zxy : x;
    vec3 n = isX ? strandNormal.yzx : isY ? strandNormal.zxy : strandNormal;
    Lattice lattice;
    lattice.place = clamp(turned.xy, vec2(-MAX_CELL), vec2(MAX_CELL));
    vec3 slide = strandSlide * density;
    lattice.way = isX ? slide.yz : isY ? slide.zx : slide.xy;
    lattice.way *= min(1.0, MAX_WAY * inversesqrt(max(dot(lattice.way, lattice.way), 1e-12)));
    lattice.slope = abs(n.z) > 0.1 ? -n.xy / n.z : vec2(0.0);
    lattice.face = (isX ? 0 : isY ? 1 : 2) + (n.z < 0.0 ? 3 : 0);
    vec3 across = max(abs(dFdx(x)), abs(dFdy(x)));
    lattice.pixel = clamp(max(max(across.x, across.y), across.z), 1e-4, 1e4);
    return lattice;
}

// What is known of a strand before its place: nothing says which one it is.
Strand meanStrand(float height) {
    Strand s;
    s.height = height;
    s.n = vec3(0.0, 0.0, 1.0);
    s.nl = 1.0;
    s.size = 0.5;
    s.shade = 0.5;
    s.phase = 0.5;
    return s;
}

// The share of a pixel that a strand of this radius covers whose middle is so far away.
float strandCover(float radius, float away, float pixel) {
    return clamp((radius - away) / pixel + 0.5, 0.0, 1.0) -
        clamp((-radius - away) / pixel + 0.5, 0.0, 1.0);
}

// Takes a strand in the lattice's cell where it covers more than those before: as far as the ray
// passes it between this layer and the next one. Of its radius and its curl no more counts than
// keeps it within half a cell, since cells beyond are not looked at.
void tryCell(Lattice lattice, ivec2 cell, float height, float layer, float share,
    inout float cover) {
    uvec3 bits = cellBits(ivec3(cell, lattice.face));
    vec3 high = vec3(bits >> 16u) * PER_HALF;
    if (high.z >= share) {
        return;
    }
    vec3 low = vec3(bits & 65535u) * PER_HALF;
    vec2 from = vec2(cell) + high.xy - lattice.place;
    float passed = dot(from, lattice.way) / max(dot(lattice.way, lattice.way), 1e-12);
    passed = clamp(passed, 0.0, 1.0);
    Strand s = meanStrand(max(height - passed * layer, 0.0));
    s.size = low.x;
    s.shade = low.y;
    s.phase = low.z;
    float radius = clamp(shellsRadius(s, shells), 0.0, 0.5);
    vec2 curl = shellsCurl(s, shells);
    curl *= min(1.0, (0.5 - radius) * inversesqrt(max(dot(curl, curl), 1e-12)));
    vec2 away = from + curl - passed * lattice.way;
    float rise = dot(lattice.slope, away);
    float covered = strandCover(radius, sqrt(dot(away, away) + rise * rise), lattice.pixel);
    if (covered > cover) {
        cover = covered;
        strand = s;
    }
}

// The share of the pixel that strands cover between a height and the layer below it, when `share`
// of the cells have one. From where a pixel is as wide as a cell no strand can be told from the
// others and the mean counts.
float coverAt(float height, float layer, float density, float share) {
    Lattice lattice = latticeAt(density);
    strand = meanStrand(height);
    float far = smoothstep(0.5, 1.5, lattice.pixel);
    float radius = clamp(shellsRadius(strand, shells), 0.0, 0.5);
    float area = radius * (PI * radius + 2.0 * length(lattice.way));
    float mean = share * min(area, 1.0);
    if (far >= 1.0) {
        return mean;
    }
    float cover = 0.0;
    ivec2 corner = ivec2(floor(lattice.place + 0.5 * lattice.way - 0.5));
    for (int i = 0; i < 4; ++i) {
        tryCell(lattice, corner + ivec2(i & 1, i >> 1), height, layer, share, cover);
    }
    strand.shade = mix(strand.shade, 0.5, far);
    return mix(cover, mean, far);
}

// A number of the pixel and the layer that differs from its neighbours' (after J. Jimenez,
// Next Generation Post Processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014).
float coverNoise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))) +
        0.618034 * shellHeight * float(SHELL_LAYERS));
}

// Leaves those samples of the pixel undrawn that no strand covers.
void keepCovered(float cover) {
    float noise = coverNoise();
    int kept = 0;
    for (int i = 0; i < 16; ++i) {
        kept |= fract(noise + 0.618034 * float(i)) < cover ? 1 << i : 0;
    }
    kept &= gl_SampleMaskIn[0];
    if (kept == 0) {
        discard;
    }
    gl_SampleMask[0] = kept;
}

// Finds the strand. `grown` and `share` are what images leave of the length and the density.
void growStrand(float grown, float density, float share) {
    strand = meanStrand(0.0);
    gl_SampleMask[0] = gl_SampleMaskIn[0];
    if (isSkin()) {
        return;
    }
    float own = 1.0 / max(grown, 1e-6);
    float height = shellHeight * own;
    float layer = own / float(SHELL_LAYERS);
    float cover = coverAt(min(height, 1.0), layer, density, share);
    keepCovered(height <= 1.0 ? FIN_SHARE * cover : 0.0);
}

// The shells have one side: what faces away belongs to strands beyond the rim, whose normals are
// only turned as far as the viewer sees them.
Surface shellSurface(Surface s) {
    if (!isSkin()) {
        s.n = unitTowardsViewer(worldNormal, s.v);
        s.t = tangentBeside(s.n, worldTangent);
        s.b = cross(s.n, s.t);
    }
    return s;
}
