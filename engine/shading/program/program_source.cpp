// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/program_source.h"

#include <filesystem>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include "shading/program/source_builder.h"

namespace patina {
namespace {

constexpr const char* prelude = "#version 410 core\n#define OUT(T) out T\n";

std::filesystem::path shaderRoot(const Catalog& catalog) {
    return catalog.roots.empty() ? std::filesystem::path() : catalog.roots.front().folder;
}

Checked<ProgramSource> joined(const SourceBuilder& vertex, const SourceBuilder& fragment) {
    Checked<ShaderSource> vertexText = vertex.finish();
    Checked<ShaderSource> fragmentText = fragment.finish();
    if (!vertexText) {
        return tl::unexpected(vertexText.error());
    }
    if (!fragmentText) {
        return tl::unexpected(fragmentText.error());
    }
    return ProgramSource{std::move(*vertexText), std::move(*fragmentText)};
}

} // namespace

std::string ProgramSource::hash() const {
    const boost::uuids::name_generator_sha1 generate(boost::uuids::ns::oid());
    const std::string between = geometry ? '\0' + geometry->text : std::string();
    return boost::uuids::to_string(generate(vertex.text + '\0' + fragment.text + between));
}

Checked<ProgramSource> program(const Catalog& catalog, const StageWriter& writeVertex,
                               const StageWriter& writeFragment, const StageWriter& writeGeometry) {
    SourceBuilder vertex(shaderRoot(catalog));
    vertex.add(prelude);
    writeVertex(vertex);
    SourceBuilder fragment(shaderRoot(catalog));
    fragment.add(prelude);
    writeFragment(fragment);
    Checked<ProgramSource> both = joined(vertex, fragment);
    if (!both || !writeGeometry) {
        return both;
    }
    SourceBuilder geometry(shaderRoot(catalog));
    geometry.add(prelude);
    writeGeometry(geometry);
    Checked<ShaderSource> text = geometry.finish();
    if (!text) {
        return tl::unexpected(text.error());
    }
    both->geometry = std::move(*text);
    return both;
}

Checked<ProgramSource> screenProgram(const Catalog& catalog, const StageWriter& write) {
    return program(
        catalog, [](SourceBuilder& vertex) { vertex.addFile("passes/screen.vert"); }, write);
}

Checked<ProgramSource> passProgram(const Catalog& catalog, const std::string& vertexFile,
                                   std::span<const std::string> fragmentFiles) {
    SourceBuilder vertex(shaderRoot(catalog));
    vertex.add(prelude);
    vertex.addFile(vertexFile);
    SourceBuilder fragment(shaderRoot(catalog));
    fragment.add(prelude);
    for (const std::string& file : fragmentFiles) {
        fragment.addFile(file);
    }
    return joined(vertex, fragment);
}

} // namespace patina
