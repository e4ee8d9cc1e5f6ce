// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "catalog/catalog.h"
#include "core/error.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Holds the text of a whole program. Uniform blocks are called ViewBlock, SceneBlock and
/// ObjectBlock.
struct ProgramSource {
    ShaderSource vertex;
    ShaderSource fragment;
    /// Only programs that make lines from the edges of a mesh have one.
    std::optional<ShaderSource> geometry{};

    /// Returns a name-based UUID (128 bits of SHA-1, by Boost.Uuid) of all texts.
    std::string hash() const;
};

class SourceBuilder;

/// Adds the text of a stage.
using StageWriter = std::function<void(SourceBuilder&)>;

Checked<ProgramSource> program(const Catalog& catalog, const StageWriter& writeVertex,
                               const StageWriter& writeFragment,
                               const StageWriter& writeGeometry = {});

/// Assembles a program that covers the target; `write` adds its fragment stage.
Checked<ProgramSource> screenProgram(const Catalog& catalog, const StageWriter& write);

/// Assembles a program from files of the shader folder alone.
Checked<ProgramSource> passProgram(const Catalog& catalog, const std::string& vertexFile,
                                   std::span<const std::string> fragmentFiles);

} // namespace patina
