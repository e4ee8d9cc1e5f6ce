// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/program_cache.h"

#include <optional>

#include <epoxy/gl.h>

#include "shading/glsl/compile_log.h"
#include "shading/program/block_gate.h"
#include "shading/program/program_file.h"

namespace patina {

namespace {

/// Compiles the geometry stage; gives nothing where the program has none.
Checked<std::optional<gl::Shader>> geometryOf(const ProgramSource& source) {
    if (!source.geometry) {
        return std::nullopt;
    }
    auto compiled = gl::Shader::compile(GL_GEOMETRY_SHADER, source.geometry->text);
    if (!compiled) {
        return tl::unexpected(compileErrors(compiled.error(), *source.geometry));
    }
    return std::move(*compiled);
}

} // namespace

Checked<gl::Program> compileProgram(const ProgramSource& source) {
    const auto vertex = gl::Shader::compile(GL_VERTEX_SHADER, source.vertex.text);
    if (!vertex) {
        return tl::unexpected(compileErrors(vertex.error(), source.vertex));
    }
    const auto fragment = gl::Shader::compile(GL_FRAGMENT_SHADER, source.fragment.text);
    if (!fragment) {
        return tl::unexpected(compileErrors(fragment.error(), source.fragment));
    }
    const auto geometry = geometryOf(source);
    if (!geometry) {
        return tl::unexpected(geometry.error());
    }
    auto program = gl::Program::link(*vertex, *fragment, *geometry ? &**geometry : nullptr);
    if (!program) {
        return tl::unexpected(compileErrors(program.error(), source.fragment));
    }
    return std::move(*program);
}

ProgramCache::ProgramCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

ProgramCache::Found ProgramCache::get(const ProgramSource& source) {
    if (BlockGate::Answer answer = gateAnswer(source); !answer.mistakes.empty()) {
        return {nullptr, std::move(answer.mistakes), false, answer.isFinal};
    }
    const std::string hash = source.hash();
    const auto known = found_.find(hash);
    if (known != found_.end()) {
        return known->second;
    }
    Found found = build(source, hash);
    Found kept = found;
    kept.compiled = false;
    found_.emplace(hash, std::move(kept));
    return found;
}

ProgramCache::Found ProgramCache::build(const ProgramSource& source, const std::string& hash) {
    const ProgramFile file(folder_, hash);
    if (auto stored = file.read()) {
        if (auto program = gl::Program::load(*stored)) {
            return {std::make_shared<const gl::Program>(std::move(*program)), {}, false};
        }
    }
    ++compiledCount_;
    auto program = compileProgram(source);
    if (!program) {
        return {nullptr, program.error(), true};
    }
    if (const auto binary = program->binary()) {
        file.write(*binary);
    }
    return {std::make_shared<const gl::Program>(std::move(*program)), {}, true};
}

} // namespace patina
