// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/mesh.h"
#include "core/progress.h"

namespace patina {

/// Returns the openness of a mesh (opennessOf()) as a file of the folder has it, whose name says
/// what is in the mesh; without one it is made and kept there. A file that is damaged is replaced,
/// and one that cannot be written is not kept. The folder's oldest files go when there are more
/// than some hundred megabytes. An empty folder: nothing is kept. Empty where it was cancelled.
std::vector<VertexOpenness> keptOpenness(const MeshView& mesh, const std::filesystem::path& folder,
                                         Progress* progress = nullptr);

/// Returns the file in which keptOpenness() keeps it.
std::filesystem::path opennessFile(const MeshView& mesh, const std::filesystem::path& folder);

/// Returns $XDG_CACHE_HOME/patina/openness, or an empty path where there is no such folder.
std::filesystem::path opennessFolder();

} // namespace patina
