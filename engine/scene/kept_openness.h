// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/mesh.h"
#include "core/progress.h"

namespace patina {

/// Tells whether objects are to hide ambient light from themselves and the scene has such light.
bool wantsOpenness(const Scene& scene);

/// Returns the openness of a mesh (opennessOf()) from a file of the folder, whose name is a hash of
/// the mesh; where there is no such file, it is computed and kept there. A damaged file is
/// replaced, and one that cannot be written is not kept. The oldest files are removed when all
/// together exceed 256 MiB. Nothing is kept where `folder` is empty. The result is empty where it
/// was cancelled.
std::vector<VertexOpenness> keptOpenness(const MeshView& mesh, const std::filesystem::path& folder,
                                         Progress* progress = nullptr);

/// Returns the file in which keptOpenness() keeps it.
std::filesystem::path opennessFile(const MeshView& mesh, const std::filesystem::path& folder);

/// Returns $XDG_CACHE_HOME/patina/openness; empty where the user has no cache folder.
std::filesystem::path opennessFolder();

} // namespace patina
