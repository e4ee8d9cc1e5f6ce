// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/json_reader.h"
#include "material/material.h"

namespace patina {

/// Returns a block with all parameters at their defaults, rounded to float as every document value.
BlockValues defaultBlockValues(const Block& block);

/// Returns the values for another block, or for another version of the same one. Values whose id
/// and type both have carry over, what does not fit goes to `parked`, and parked values that fit
/// come back. `from` is null when the block of the values is not known.
BlockValues carriedOver(const BlockValues& values, const Block* from, const Block& to,
                        nlohmann::json& parked);

/// Copies all values to `parked`, by id.
void park(const Values& values, nlohmann::json& parked);

/// Reads the blocks of a file against a catalogue and collects notes.
struct BlockReader {
    const Catalog& catalog;
    Errors& notes;

    /// Reads "id" and "version" from `block` and the values from `parameters`, which a preset has
    /// beside its model. What does not fit goes to `parked`.
    BlockValues read(JsonReader& block, JsonReader& parameters, std::string_view kind,
                     nlohmann::json& parked) const;

    /// Reads {"id", "version", "parameters"}; what does not fit is parked in the block itself.
    BlockValues read(JsonReader& block, std::string_view kind) const;
};

/// Returns {"id", "version", "parameters"} and the keys that the reader did not know.
nlohmann::json toJson(const BlockValues& values);

/// Returns the values alone, with those that the reader did not know.
nlohmann::json parametersJson(const BlockValues& values);

} // namespace patina
