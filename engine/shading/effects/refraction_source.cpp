// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/refraction_source.h"

#include <array>
#include <string>
#include <string_view>

#include "shading/program/source_builder.h"

namespace patina {

Checked<ProgramSource> bodyBackProgram(const Catalog& catalog) {
    static constexpr std::string_view sizes = "#define OBJECT_VEC4S 1\n#define SCENE_VEC4S 1\n";
    return program(
        catalog,
        [](SourceBuilder& vertex) {
            vertex.add(sizes);
            vertex.addFile("passes/surface.vert");
            vertex.add("void main() {\n    placeSurface();\n}\n");
        },
        [](SourceBuilder& fragment) {
            fragment.add(sizes);
            fragment.addFile("passes/surface.glsl");
            fragment.addFile("passes/refraction_back.glsl");
        });
}

Checked<ProgramSource> tileReachProgram(const Catalog& catalog) {
    static const std::array<std::string, 1> files{"passes/behind_reach.frag"};
    return passProgram(catalog, "passes/screen.vert", files);
}

} // namespace patina
