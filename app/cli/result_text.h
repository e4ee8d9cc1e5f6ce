// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace patina {

// A file of results has a line of JSON that says what was asked for (ResultHead), and below it one
// for each preset that is done (ResultLine).

/// Says what the results of a file are of.
struct ResultHead {
    std::string command;
    std::size_t presets = 0; ///< counts those of all shards
    std::size_t shard = 1;   ///< is 1-based
    std::size_t shards = 1;
    nlohmann::json
        about; ///< has what else has to be the same for all: version, options, blocks ...

    /// Tells whether the preset of a 1-based number is one of the shard's.
    bool has(std::size_t number) const { return (number - 1) % shards == shard - 1; }

    /// Returns how many presets are the shard's.
    std::size_t count() const { return presets / shards + (presets % shards >= shard ? 1 : 0); }

    /// Returns the line, with its line break.
    std::string text() const;
};

/// Names what two heads differ in, as "options, blocks"; empty where they are of the same work,
/// perhaps of different shards.
std::string differenceOf(const ResultHead& a, const ResultHead& b);

/// Is what is known of one preset.
struct ResultLine {
    std::size_t number = 0; ///< is the preset's 1-based place among those of all shards
    std::string preset;     ///< is its file as it was named
    std::string content;    ///< is the hash of what it was read from
    nlohmann::json result;  ///< is null where the work failed
    std::string failure;    ///< says why it failed

    bool hasFailed() const { return result.is_null(); }

    /// Returns the line, with its line break.
    std::string text() const;
};

/// Is a line with its place in a file.
struct PlacedLine {
    ResultLine line;
    int place = 0; ///< is 1-based
};

/// Holds what a file of results says.
struct ResultText {
    ResultHead head;
    std::vector<PlacedLine> lines; ///< keep the file's order; of two of one preset the later counts
    std::size_t wholeBytes = 0;    ///< counts the bytes up to the last line break
    bool isCut = false;            ///< says that bytes follow, of a line that was being written
};

/// Reads the text of a file of results. A mistake in a whole line is an error at its place; a last
/// line without its line break is left out.
Result<ResultText> readResults(std::string_view text, const std::string& file);

} // namespace patina
