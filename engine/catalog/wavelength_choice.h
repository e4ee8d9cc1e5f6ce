// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "catalog/block.h"

namespace patina {

/// Returns the whole number from 0 that a level's id is; nothing where it is none.
inline std::optional<int> wholeNumber(const EnumValue& level) {
    int number = 0;
    const char* end = level.id.data() + level.id.size();
    const auto read = std::from_chars(level.id.data(), end, number);
    return read.ec == std::errc() && read.ptr == end && number >= 0 ? std::optional(number)
                                                                    : std::nullopt;
}

/// Returns the accuracy choice of a refraction block whose levels count the wavelengths that bend
/// apart: whole numbers from 1. The program reads it, and the block's struct has no field of it.
/// Null where there is none.
inline const AccuracyChoice* wavelengthChoice(const Block& block) {
    if (block.kind != kinds::refraction) {
        return nullptr;
    }
    const auto found = std::ranges::find_if(block.accuracy, [](const AccuracyChoice& choice) {
        return !choice.values.empty() &&
               std::ranges::all_of(choice.values, [](const EnumValue& level) {
                   return wholeNumber(level).value_or(0) > 0;
               });
    });
    return found == block.accuracy.end() ? nullptr : &*found;
}

} // namespace patina
