// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/error.h"

namespace patina {

/// Holds a vertex and a fragment stage in SPIR-V, and what a pipeline must provide for them.
struct SpirvProgram {
    enum class Resource { UniformBlock, Sampler, TexelBuffer };

    /// Is a resource of descriptor set 0.
    struct Binding {
        std::uint32_t number = 0;
        Resource resource = Resource::UniformBlock;
    };

    /// Is one location of the vertices' attributes; a matrix takes several.
    struct Attribute {
        enum class Type { Float, Int, Uint };
        std::uint32_t location = 0;
        Type type = Type::Float;
    };

    std::vector<std::uint32_t> vertex;
    std::vector<std::uint32_t> fragment;
    std::vector<Binding> bindings;
    std::vector<Attribute> attributes;
    std::uint32_t outputs = 0; ///< counts the colour attachments that the fragment stage writes
};

/// Compiles both stages of an OpenGL program for Vulkan with glslang: resources and interfaces get
/// numbers, plain uniforms go into one block. It is an error where the text does not compile.
Result<SpirvProgram> spirvProgram(const std::string& vertex, const std::string& fragment);

} // namespace patina
