// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "material/texture_use.h"

namespace patina {

/// Holds a block chosen by id, with its values. The id may be one that the catalogue does not know:
/// the values are then kept as they came.
struct BlockValues {
    std::string id;
    int version = 1;
    Values parameters;
    nlohmann::json unknown = nlohmann::json::object(); ///< holds keys the reader did not know

    friend bool operator==(const BlockValues&, const BlockValues&) = default;
};

/// Maps a kind that an owner may do without (partKinds()) to what is chosen of it; an absent kind
/// is off.
using BlockParts = std::map<std::string, BlockValues, std::less<>>;

/// Returns what is chosen of a kind; null where nothing is.
const BlockValues* partOf(const BlockParts& parts, std::string_view kind);
BlockValues* partOf(BlockParts& parts, std::string_view kind);

/// Returns the block that is chosen of a kind; null where none is or the catalogue does not know
/// it.
const Block* blockOf(const BlockParts& parts, std::string_view kind, const Catalog& catalog);

/// Chooses a block of a kind, or none.
void setPart(BlockParts& parts, std::string_view kind, std::optional<BlockValues> values);

/// Is a lighting model with parameter values: what an artist makes, and what a preset holds.
struct Material {
    std::string name;
    std::string description;
    std::string author;
    std::string license;
    std::vector<std::string> tags;
    BlockValues model;
    BlockParts parts;     ///< fill the model's slots, or work beside any (hasPlaceFor())
    double opacity = 1.0; ///< 0 .. 1
    AccuracyLevels accuracy;
    std::map<std::string, TextureUse, std::less<>>
        textures;                                     ///< have the parameter's id as key, with
                                                      ///< "<kind>." before a part's; by
                                                      ///< "normal", "height", "opacity"
    nlohmann::json parked = nlohmann::json::object(); ///< holds values unused by its blocks
    nlohmann::json extras = nlohmann::json::object();
    nlohmann::json unknown = nlohmann::json::object(); ///< holds unknown keys to write back

    const BlockValues* part(std::string_view kind) const { return partOf(parts, kind); }
    BlockValues* part(std::string_view kind) { return partOf(parts, kind); }

    friend bool operator==(const Material&, const Material&) = default;
};

/// Returns a material of `model` with every parameter at its default.
Material defaultMaterial(const Block& model);

/// Returns the material with another model. Values whose parameter id and type both models have
/// carry over, the others are parked; parked values that the new model knows come back. `oldModel`
/// is null where the catalogue does not know it.
Material withModel(const Material& material, const Block* oldModel, const Block& newModel);

/// Returns the material with another block for a part; a null `newBlock` turns the part off and
/// parks its values. `oldBlock` is null where none was chosen or it is not known.
Material withPart(const Material& material, std::string_view kind, const Block* oldBlock,
                  const Block* newBlock);

} // namespace patina
