// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/mesh_material.h"
#include "material/material.h"

namespace patina {

/// Says how a model looks like the materials of mesh files, as its descriptor states.
struct MeshLook {
    std::string look;                     ///< is that of MeshMaterial
    std::vector<std::string> assignments; ///< are made in a material of the model's defaults
    /// Maps a word of MeshMaterial to the id of a parameter, with "<kind>." before a part's.
    std::map<std::string, std::string> values;
};

/// Returns the looks of a model, the first one that it should be taken for first. They are read
/// from its descriptor each time, since only files of other programs ask for them.
Result<std::vector<MeshLook>> meshLooksOf(const Block& model);

/// Holds a look with the model that states it.
struct ModelLook {
    const Block* model = nullptr;
    MeshLook look;

    /// Returns a material of the model's defaults with the assignments of the look.
    Result<Material> start(const Catalog& catalog) const;
};

/// Returns the look with the model that materials of mesh files get for it, by
/// presets/mesh-looks.json. Fails where that names none or cannot be read, or where the model does
/// not state the look.
Result<ModelLook> importedLook(const std::string& look, const Catalog& catalog);

/// Returns the preset that looks as a mesh file says of a material, by importedLook(), with its
/// images.
Result<Material> materialOf(const MeshMaterial& from, const Catalog& catalog);

} // namespace patina
