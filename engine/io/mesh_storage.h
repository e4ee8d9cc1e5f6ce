// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/error.h"
#include "core/mesh.h"
#include "core/mesh_material.h"

namespace patina {

/// Says where a finished mesh is to be written.
struct MeshSpans {
    std::span<Vertex> vertices;
    std::span<std::uint32_t> indices;
    std::span<VertexColor> colors; ///< are those of the parts that have some
};

/// Allocates memory for exactly these parts, one after the other, and keeps what is said of them.
/// It is called once, when the counts are known, so that a mesh is written where it is used and
/// never copied.
using MeshStorage = std::function<Result<MeshSpans>(std::span<const MeshPart> parts)>;

} // namespace patina
