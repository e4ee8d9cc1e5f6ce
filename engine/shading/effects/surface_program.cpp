// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/surface_program.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "shading/effects/surface_buffer_layout.h"
#include "shading/effects/surface_text.h"
#include "shading/program/table_writer.h"

namespace patina {
namespace {

void writeSize(SurfaceText& text) {
    text.out.add(fmt::format("#define OBJECT_VEC4S {}\n", text.object.vec4s));
}

/// Writes each effect's part of what lights a surface.
void writeAllLight(SurfaceText& text) {
    text.set.each([&text](const auto& effect) {
        if constexpr (requires { effect.writeLight(text); }) {
            effect.writeLight(text);
        }
    });
}

/// Writes what becomes of the light of a surface.
void writeRest(SurfaceText& text) {
    text.set.each([&text](const auto& effect) {
        if constexpr (requires { effect.write(text); }) {
            effect.write(text);
        }
    });
}

void writeFrame(SurfaceText& text) {
    writeSize(text);
    text.out.addFile("passes/surface.glsl");
    if (text.leavesNormals()) {
        text.out.addFile("passes/interpolated_normal.glsl");
    }
    if (text.isInspected()) {
        text.out.addFile("passes/inspection.glsl");
    }
    text.textures.writeDeclarations(text.out);
    if (text.drawsShells()) {
        writeShells(text);
    }
    if (text.isOfMarks) {
        writeMarks(text);
    }
    text.main += text.textures.relief();
    text.readFrom("objectData");
}

/// Light that was worked out at vertices. A surface that glows needs its model's values at the
/// pixel, since a Fresnel term comes between.
void writeBlendedLight(SurfaceText& text) {
    if (!text.set.emission.empty()) {
        writeModel(text);
    }
    text.out.addFile("passes/blended_light.glsl");
    text.main += "    shaded = blendedLight(s);\n";
}

void writeMain(SurfaceText& text) {
    // The table knows one value for the whole surface.
    const char* albedo = text.set.model && text.set.textures.empty() ? "albedoAt(s)" : "vec4(0.0)";
    const std::string store =
        text.isInspected()
            ? fmt::format("storeInspected(s, {}, {}, {})", text.stored, albedo, text.alpha)
            : fmt::format(fmt::runtime(text.store), text.stored, text.alpha);
    text.out.add(fmt::format(
        "void main() {{\n{}    Surface s = {}();\n    vec3 shaded = vec3(0.0);\n"
        "{}{}    {};\n}}\n",
        text.isInspected() ? "    clearTerms();\n" : "",
        text.leavesNormals() ? "blendedSurface" : "surface", text.main, text.last, store));
}

void writeSurface(SurfaceText& text) {
    if (text.set.model && text.lightsAtVertices()) {
        writeBlendedLight(text);
    } else if (isLit(text.set)) {
        writeAllLight(text);
    } else {
        text.out.addFile("passes/fallback.glsl");
        text.main += "    shaded = fallback(s);\n";
    }
    writeRest(text);
    writeMain(text);
}

/// Writes the model alone.
void writeAlbedoTable(SurfaceText& text) {
    writeSize(text);
    for (const char* file : {"passes/blocks.glsl", "lib/directions.glsl", "lib/math.glsl"}) {
        text.out.addFile(file);
    }
    text.readFrom("objectData");
    writeModel(text);
    const AlbedoTableShape shape = albedoTableShape(text.set.model->block());
    text.out.add(
        fmt::format("#define TABLE_WIDTH {}\n#define TABLE_HEIGHT {}\n#define SECTORS {}\n",
                    shape.size.x, shape.size.y, shape.sectors));
    text.out.addFile("passes/albedo_table.glsl");
    text.out.add("void main() {\n" + text.main + "    storeAlbedo(model);\n}\n");
}

/// Writes the model alone, for each viewer and direction of light of a table of lobes.
void writeLobeSamples(SurfaceText& text) {
    writeSize(text);
    text.out.addFile("passes/blocks.glsl");
    text.out.add(lobeTableSource(lobeTableShape(text.set.model->block())));
    text.readFrom("objectData");
    writeModel(text);
    text.out.addFile("passes/lobe_samples.glsl");
    text.out.add("void main() {\n" + text.main + "    storeSample(model);\n}\n");
}

/// Writes what fills the tables that blocks read.
void writeTables(SurfaceText& text) {
    writeSize(text);
    text.out.addFile("passes/blocks.glsl");
    text.readFrom("objectData");
    if (text.set.model) {
        writeModel(text);
    }
    if (text.set.blend) {
        text.addBlock(text.set.blend->block());
        text.addUnpack(*text.set.blend, "unpackBlend");
    }
    text.out.add(fillingSource(text.object.tables));
}

void writeFragment(SurfaceText& text) {
    switch (text.output) {
    case SurfaceOutput::AlbedoTable:
        writeAlbedoTable(text);
        break;
    case SurfaceOutput::LobeSamples:
        writeLobeSamples(text);
        break;
    case SurfaceOutput::Tables:
        writeTables(text);
        break;
    case SurfaceOutput::Buffer:
        writeFrame(text);
        writeBuffer(text);
        break;
    default:
        writeFrame(text);
        writeSurface(text);
    }
}

/// Returns the same functions as at a pixel, without what only a pixel has.
std::string writeVertexLight(SurfaceText& text) {
    text.out.addFile("passes/vertex_light.glsl");
    text.readFrom("objectData");
    writeAllLight(text);
    text.out.add("vec3 vertexLight(Surface s) {\n    vec3 shaded = vec3(0.0);\n" + text.main +
                 "    return shaded;\n}\n");
    text.main.clear();
    return "    frontLight = storableLight(vertexLight(vertexSurface(1.0)));\n"
           "    backLight = storableLight(vertexLight(vertexSurface(-1.0)));\n";
}

/// Writes what the vertex stage works out for a picture behind passes/surface.vert, and returns the
/// statements of its main.
std::string writeVertices(SurfaceText& text, int sceneVec4s) {
    std::string work;
    if (text.drawsShells()) {
        work += writeShellsVertex(text);
    }
    if (text.isOfMarks) {
        work += writeMarksVertex(text);
    }
    if (text.leavesNormals()) {
        text.out.addFile("lib/math.glsl");
        work += "    worldNormal = safeNormalize(worldNormal, vec3(0.0));\n";
    }
    if (text.lightsAtVertices() || text.fogsAtVertices()) {
        text.out.add(fmt::format("#define SCENE_VEC4S {}\n", sceneVec4s));
        text.out.addFile("passes/surface_point.glsl");
    }
    if (text.lightsAtVertices()) {
        work += writeVertexLight(text);
    }
    if (text.fogsAtVertices()) {
        work += writeVertexFog(text);
    }
    return work;
}

/// Writes each effect's part of the vertex stage and returns its statements.
std::string writeEffectVertices(SurfaceText& text) {
    std::string statements;
    text.set.each([&](const auto& effect) {
        if constexpr (requires { effect.writeVertex(text.out); }) {
            statements += effect.writeVertex(text.out);
        }
    });
    return statements;
}

/// Is what a fragment is handed by the stage before it.
struct Varying {
    std::string type; ///< with its qualifier: "centroid in vec3"
    std::string name;

    /// Returns the name under which the skin's vertices hand it on to fins.
    std::string ofSkin() const {
        std::string capital = name;
        capital.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
        return "skin" + capital;
    }
};

/// Lists what a fragment stage is handed by the vertices: all but what fins add themselves.
std::vector<Varying> varyingsOf(const std::string& fragment) {
    std::vector<Varying> varyings;
    for (std::size_t begin = 0; begin < fragment.size();) {
        const std::size_t end = std::min(fragment.find('\n', begin), fragment.size());
        const std::string_view line(fragment.data() + begin, end - begin);
        begin = end + 1;
        if (!line.starts_with("in ") && !line.starts_with("centroid in ")) {
            continue;
        }
        const std::string_view declared = line.substr(0, line.find(';'));
        const std::size_t space = declared.rfind(' ');
        Varying varying{std::string(declared.substr(0, space)),
                        std::string(declared.substr(space + 1))};
        if (varying.name != "finShare") {
            varyings.push_back(std::move(varying));
        }
    }
    return varyings;
}

/// Returns the text of a geometry stage that takes them from the skin's corners and hands them on.
std::string passingSource(const std::vector<Varying>& varyings) {
    std::string declared = "layout(lines_adjacency) in;\n";
    std::string passed = "void passOn(int corner) {\n";
    for (const Varying& varying : varyings) {
        std::string handed = varying.type;
        handed.replace(handed.find("in "), 2, "out");
        declared += fmt::format("{0} {1}[];\n{2} {3};\n", varying.type, varying.ofSkin(), handed,
                                varying.name);
        passed += fmt::format("    {} = {}[corner];\n", varying.name, varying.ofSkin());
    }
    return declared + passed + "}\n";
}

} // namespace

void addSurfaceVertex(SourceBuilder& vertex, const EffectSet& set, const ObjectLayout& layout,
                      const VertexWork& work, SurfaceOutput output) {
    vertex.add(fmt::format("#define OBJECT_VEC4S {}\n", layout.vec4s));
    const std::string images =
        TextureWriter(set, layout).writeVertex(vertex, output == SurfaceOutput::Inspection);
    if (layout.isPeeled()) {
        vertex.add("invariant gl_Position;\n");
    }
    vertex.addFile("passes/surface.vert");
    const std::string more = work ? work(vertex) : std::string();
    vertex.add(fmt::format("void main() {{\n    placeSurface();\n{}{}}}\n", images, more));
}

Checked<ProgramSource> surfaceProgram(const EffectSet& set, const Catalog& catalog,
                                      SurfaceOutput output, int sceneVec4s) {
    const ObjectLayout object = objectLayout(set);
    const SceneLayout scene = sceneLayout(set);
    const auto writeVertex = [&](SourceBuilder& vertex) {
        if (isTable(output)) {
            vertex.add(fmt::format("#define OBJECT_VEC4S {}\n", object.vec4s));
            vertex.addFile("passes/screen.vert");
            return;
        }
        const VertexWork work = [&](SourceBuilder& stage) {
            SurfaceText text(stage, set, object, scene);
            const std::string statements = writeEffectVertices(text);
            return statements + (output == SurfaceOutput::Picture ? writeVertices(text, sceneVec4s)
                                                                  : std::string());
        };
        addSurfaceVertex(vertex, set, object, work, output);
    };
    return program(catalog, writeVertex, [&](SourceBuilder& fragment) {
        if (!isTable(output)) {
            fragment.add(fmt::format("#define SCENE_VEC4S {}\n", sceneVec4s));
        }
        SurfaceText text(fragment, set, object, scene, output);
        writeFragment(text);
    });
}

Checked<ProgramSource> finsProgram(const EffectSet& set, const Catalog& catalog, int sceneVec4s) {
    const ObjectLayout object = objectLayout(set);
    const SceneLayout scene = sceneLayout(set);
    const auto writeFins = [&](SourceBuilder& fragment) {
        fragment.add(fmt::format("#define SCENE_VEC4S {}\n", sceneVec4s));
        SurfaceText text(fragment, set, object, scene);
        text.isOfFins = true;
        writeFragment(text);
    };
    const auto alone = program(
        catalog, [](SourceBuilder&) {}, writeFins);
    if (!alone) {
        return alone;
    }
    const std::vector<Varying> varyings = varyingsOf(alone->fragment.text);
    const auto writeVertex = [&](SourceBuilder& vertex) {
        for (const Varying& varying : varyings) {
            vertex.add(fmt::format("#define {} {}\n", varying.name, varying.ofSkin()));
        }
        addSurfaceVertex(vertex, set, object, [&](SourceBuilder& stage) {
            SurfaceText text(stage, set, object, scene);
            text.isOfFins = true;
            const std::string statements = writeEffectVertices(text);
            return statements + writeShellsVertex(text);
        });
    };
    return program(catalog, writeVertex, writeFins, [&](SourceBuilder& geometry) {
        geometry.add(fmt::format("#define OBJECT_VEC4S {}\n", object.vec4s));
        geometry.addFile("passes/blocks.glsl");
        geometry.add(passingSource(varyings));
        geometry.addFile("passes/fins.glsl");
        geometry.add("void main() {\n    drawFin();\n}\n");
    });
}

Checked<ProgramSource> marksProgram(const EffectSet& set, const Catalog& catalog, int sceneVec4s) {
    const ObjectLayout object = objectLayout(set);
    const SceneLayout scene = sceneLayout(set);
    const auto writeVertex = [&](SourceBuilder& vertex) {
        addSurfaceVertex(vertex, set, object, [&](SourceBuilder& stage) {
            SurfaceText text(stage, set, object, scene);
            text.isOfMarks = true;
            const std::string statements = writeEffectVertices(text);
            return statements + writeVertices(text, sceneVec4s);
        });
    };
    return program(catalog, writeVertex, [&](SourceBuilder& fragment) {
        fragment.add(fmt::format("#define SCENE_VEC4S {}\n", sceneVec4s));
        SurfaceText text(fragment, set, object, scene);
        text.isOfMarks = true;
        writeFragment(text);
    });
}

} // namespace patina
