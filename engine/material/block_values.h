// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/json_reader.h"
#include "material/material.h"

namespace patina {

/// Returns a block with all parameters at their defaults, rounded to float as all in a document.
BlockValues defaultBlockValues(const Block& block);

/// Returns the values for another block, or for another version of the same one: values whose id
/// and type both have carry over, what does not fit goes to `parked`, and parked values that fit
/// come back. `from` is null when the block of the values is not known.
BlockValues carriedOver(const BlockValues& values, const Block* from, const Block& to,
                        nlohmann::json& parked);

/// Moves all values to `parked`.
void park(const Values& values, nlohmann::json& parked);

/// Says where notes go and what blocks there are while a file is read.
struct BlockReader {
    const Catalog& catalog;
    Errors& notes;

    /// Reads "id" and "version" of a block object and its values, which may stand elsewhere.
    BlockValues read(JsonReader& block, JsonReader& parameters, std::string_view kind,
                     nlohmann::json& parked) const;

    /// Reads {"id", "version", "parameters"}; what does not fit is parked in the block itself.
    BlockValues read(JsonReader& block, std::string_view kind) const;
};

/// {"id", "version", "parameters"} and the keys the reader did not know.
nlohmann::json toJson(const BlockValues& values);

/// The values alone, with those the reader did not know.
nlohmann::json parametersJson(const BlockValues& values);

} // namespace patina
