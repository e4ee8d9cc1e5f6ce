// SPDX-License-Identifier: MIT-0
// From an edge, the corners that its faces have beside it before and behind it, to its lines.
#include "passes/blocks.glsl"
#include "lib/edge.glsl"

layout(lines_adjacency) in;
layout(triangle_strip, max_vertices = 30) out;

in vec3 edgeCorner[];
out vec3 linePoint;

// xy: a pixel of the picture in clip space; z: what nears a point to the eye by as much as it is
// wide there, in clip space, the same at every distance.
#define LINE_DATA objectData[0]

// Steps in which a quarter of a round end is drawn, and their sines and cosines.
const int ROUND_STEPS = 3;
const vec2 ROUND[4] = vec2[4](vec2(0.0, 1.0), vec2(0.5, 0.8660254), vec2(0.8660254, 0.5),
                              vec2(1.0, 0.0));

// Faces that are thinner than this in proportion have no direction of their own.
const float MIN_FACE = 1e-4;

// A line on a surface lies half a pixel's width in front of it; one outside as far behind its edge,
// so that whatever part of the shape lies beside it hides it.
const float LIFT = 0.5;

// Steeper than this, in widths of a pixel, a surface is followed as deep as its face reaches only.
const float STEEPEST = 8.0;

// Square pixels: a face that covers less is seen edge-on.
const float MIN_AREA = 1e-6;

// A plane in which a face lies, as depth over the picture.
struct FacePlane {
    vec2 slope;    // in pixels
    float reach;   // from the edge to the corner beside it
};

// The side of a line on which faces lie, and how wide the line is.
struct LineSide {
    vec2 across;   // unit, away from the line
    FacePlane a;   // the nearer of the two counts
    FacePlane b;
    float width;   // pixels
    float lift;    // towards the eye
};

vec4 edgeFrom;
vec4 edgeTo;
vec3 pointFrom;
vec3 pointTo;
vec2 pixelFrom; // of the picture, from its middle
vec2 along;     // unit

vec2 pixelOf(vec4 clip) {
    return clip.xy / (clip.w * LINE_DATA.xy);
}

// The face's direction, as long as the sine of its angle at the edge.
vec3 faceDirection(vec3 edge, vec3 beside) {
    float lengths = length(edge) * length(beside);
    return lengths > 0.0 ? cross(edge / length(edge), beside / length(beside)) : vec3(0.0);
}

bool areFaces(vec3 a, vec3 b) {
    return length(a) > MIN_FACE && length(b) > MIN_FACE;
}

// The angle between the directions of the faces, which see the edge from opposite ends.
float bendBetween(vec3 a, vec3 b) {
    return areFaces(a, b) ? atan(length(cross(a, b)), -dot(a, b)) : 0.0;
}

// What lies before the near plane is cut off.
bool isCutAway() {
    float a = edgeFrom.z + edgeFrom.w;
    float b = edgeTo.z + edgeTo.w;
    if (a <= 0.0 && b <= 0.0) {
        return true;
    }
    if (a < 0.0 || b < 0.0) {
        float share = a / (a - b);
        vec4 cut = mix(edgeFrom, edgeTo, share);
        vec3 cutPoint = mix(pointFrom, pointTo, share);
        edgeFrom = a < 0.0 ? cut : edgeFrom;
        pointFrom = a < 0.0 ? cutPoint : pointFrom;
        edgeTo = b < 0.0 ? cut : edgeTo;
        pointTo = b < 0.0 ? cutPoint : pointTo;
    }
    return !(edgeFrom.w > 0.0 && edgeTo.w > 0.0);
}

// Of a line that no face is beside.
FacePlane levelPlane() {
    FacePlane plane;
    plane.slope = vec2(0.0);
    plane.reach = 0.0;
    return plane;
}

FacePlane planeOf(vec4 corner) {
    FacePlane plane = levelPlane();
    if (!(corner.w > 0.0)) {
        return plane;
    }
    vec2 u = pixelOf(edgeTo) - pixelFrom;
    vec2 v = pixelOf(corner) - pixelFrom;
    float du = edgeTo.z / edgeTo.w - edgeFrom.z / edgeFrom.w;
    float dv = corner.z / corner.w - edgeFrom.z / edgeFrom.w;
    float area = u.x * v.y - u.y * v.x;
    if (abs(area) > MIN_AREA) {
        plane.slope = vec2(du * v.y - dv * u.y, dv * u.x - du * v.x) / area;
        plane.reach = max(abs(dv), abs(dv - du));
    }
    return plane;
}

// How much deeper a plane is beside its edge.
float depthBeside(FacePlane plane, vec2 offset, vec4 end) {
    float maxShift = max(STEEPEST * length(offset) * abs(LINE_DATA.z), plane.reach * end.w);
    return clamp(dot(plane.slope, offset) * end.w, -maxShift, maxShift);
}

void emitAt(vec4 end, vec3 point, vec2 offset, LineSide s) {
    float beside = min(depthBeside(s.a, offset, end), depthBeside(s.b, offset, end));
    float depth = end.z + beside + s.lift * LINE_DATA.z;
    gl_Position = vec4(end.xy + offset * LINE_DATA.xy * end.w, clamp(depth, -end.w, end.w), end.w);
    linePoint = point;
    EmitVertex();
}

// One side of a line, with a quarter of a disk at each end that closes the gap to the next one.
void emitSide(LineSide s) {
    for (int i = 0; i <= ROUND_STEPS; ++i) {
        vec2 rim = ROUND[i].x * s.across - ROUND[i].y * along;
        emitAt(edgeFrom, pointFrom, s.width * rim, s);
        if (i < ROUND_STEPS) {
            emitAt(edgeFrom, pointFrom, vec2(0.0), s);
        }
    }
    for (int i = ROUND_STEPS; i >= 0; --i) {
        vec2 rim = ROUND[i].x * s.across + ROUND[i].y * along;
        emitAt(edgeTo, pointTo, vec2(0.0), s);
        emitAt(edgeTo, pointTo, s.width * rim, s);
    }
    EndPrimitive();
}

void emitSideOf(vec2 side, FacePlane a, FacePlane b, float width, float lift) {
    LineSide s;
    s.across = side;
    s.a = a;
    s.b = b;
    s.width = width;
    s.lift = lift;
    if (width > 0.0) {
        emitSide(s);
    }
}

void emitLines(vec2 widths, bool turns, vec2 sideA) {
    FacePlane a = planeOf(gl_in[0].gl_Position);
    FacePlane b = planeOf(gl_in[3].gl_Position);
    FacePlane level = levelPlane();
    if (turns) {
        emitSideOf(sideA, a, b, 0.5 * widths.y, LIFT);
        emitSideOf(-sideA, level, level, max(widths.x, 0.5 * widths.y), -LIFT);
    } else {
        emitSideOf(sideA, a, a, 0.5 * widths.y, LIFT);
        emitSideOf(-sideA, b, b, 0.5 * widths.y, LIFT);
    }
}

void drawEdge(Outline p) {
    vec3 from = edgeCorner[1];
    vec3 edge = edgeCorner[2] - from;
    vec3 faceA = faceDirection(edge, edgeCorner[0] - from);
    vec3 faceB = faceDirection(edge, edgeCorner[3] - from);
    bool isLeftA = dot(faceA, from - viewData[4].xyz) < 0.0;
    bool isLeftB = dot(faceB, from - viewData[4].xyz) < 0.0;
    Edge e;
    e.open = edgeCorner[0] == edgeCorner[3];
    e.silhouette = e.open || (isLeftA == isLeftB && areFaces(faceA, faceB));
    e.dihedral = e.open ? 0.0 : bendBetween(faceA, faceB);
    vec2 widths = lineWidths(e, p);
    edgeFrom = gl_in[1].gl_Position;
    edgeTo = gl_in[2].gl_Position;
    pointFrom = from;
    pointTo = edgeCorner[2];
    if (!(max(widths.x, widths.y) > 0.0) || isCutAway()) {
        return;
    }
    pixelFrom = pixelOf(edgeFrom);
    vec2 way = pixelOf(edgeTo) - pixelFrom;
    if (!(length(way) > 1e-4)) {
        return;
    }
    along = way / length(way);
    vec2 left = vec2(-along.y, along.x);
    emitLines(widths, e.silhouette, isLeftA ? left : -left);
}
