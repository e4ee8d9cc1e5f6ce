// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SurfaceWriter that writes what is worked out at vertices, and what becomes of it.
#include <fmt/format.h>

#include "shading/effects/surface_writer.h"

namespace patina {

/// The inspection and the surface buffer are exact, and the ground has four vertices.
bool SurfaceWriter::isPicture() const {
    return output_ == SurfaceOutput::Picture && set_.ground == GroundMode::Off;
}

std::string SurfaceWriter::writeVertices(int sceneVec4s) {
    std::string work;
    if (leavesNormals()) {
        out_.addFile("lib/math.glsl");
        work += "    worldNormal = safeNormalize(worldNormal, vec3(0.0));\n";
    }
    if (lightsAtVertices() || fogsAtVertices()) {
        out_.add(fmt::format("#define SCENE_VEC4S {}\n", sceneVec4s));
        out_.addFile("passes/surface_point.glsl");
    }
    if (lightsAtVertices()) {
        work += writeVertexLight();
    }
    if (fogsAtVertices()) {
        work += writeVertexFog();
    }
    return work;
}

/// The same functions as at a pixel, without what only a pixel has.
std::string SurfaceWriter::writeVertexLight() {
    out_.addFile("passes/vertex_light.glsl");
    readFrom("objectData");
    writeSlots();
    writeModel();
    writeLights();
    writeAmbient();
    writeHemisphere();
    writeKeptShare();
    out_.add("vec3 vertexLight(Surface s) {\n    vec3 shaded = vec3(0.0);\n" + main_ +
             "    return shaded;\n}\n");
    main_.clear();
    return "    frontLight = storableLight(vertexLight(vertexSurface(1.0)));\n"
           "    backLight = storableLight(vertexLight(vertexSurface(-1.0)));\n";
}

std::string SurfaceWriter::writeVertexFog() {
    writeFogBlock();
    out_.addFile("passes/vertex_fog.glsl");
    return fmt::format("    placeFog(unpackFog({}));\n", scene_.fog->first);
}

/// A surface that glows needs its model's values at the pixel, since a Fresnel term comes between.
void SurfaceWriter::writeBlendedLight() {
    if (!set_.emission.empty()) {
        writeSlots();
        writeModel();
    }
    out_.addFile("passes/blended_light.glsl");
    main_ += "    shaded = blendedLight(s);\n";
}

} // namespace patina
