// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "catalog/block.h"

namespace patina {

/// Returns the whole number from 0 that a text is; nothing where it is none.
inline std::optional<int> wholeNumber(std::string_view text) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc() && read.ptr == end && number >= 0 ? std::optional(number)
                                                                    : std::nullopt;
}

/// Returns the whole number from 0 that a level's id is; nothing where it is none.
inline std::optional<int> wholeNumber(const EnumValue& level) {
    return wholeNumber(std::string_view(level.id));
}

/// Returns how many rays a level asks for by an id such as "rays4"; nothing where it is none.
inline std::optional<int> rayCount(const EnumValue& level) {
    constexpr std::string_view word = "rays";
    return level.id.starts_with(word) ? wholeNumber(std::string_view(level.id).substr(word.size()))
                                      : std::nullopt;
}

/// Returns the accuracy choice of a refraction block of whose levels `count` makes numbers above 0;
/// null where there is none. The program reads it, and the block's struct has no field of it.
template <class Count>
const AccuracyChoice* choiceOfCounts(const Block& block, Count count) {
    if (block.kind != kinds::refraction) {
        return nullptr;
    }
    const auto found =
        std::ranges::find_if(block.accuracy, [&count](const AccuracyChoice& choice) {
            return !choice.values.empty() &&
                   std::ranges::all_of(choice.values, [&count](const EnumValue& level) {
                       return count(level).value_or(0) > 0;
                   });
        });
    return found == block.accuracy.end() ? nullptr : &*found;
}

/// Returns the choice of how many wavelengths bend apart: whole numbers from 1.
inline const AccuracyChoice* wavelengthChoice(const Block& block) {
    return choiceOfCounts(block, [](const EnumValue& level) { return wholeNumber(level); });
}

/// Returns the choice of how many rays of a pixel look for what is behind a body: "rays1", "rays4".
inline const AccuracyChoice* rayChoice(const Block& block) {
    return choiceOfCounts(block, rayCount);
}

/// Returns true when the program reads the choice, so that the block's functions do not know it.
inline bool isOfProgram(const Block& block, const AccuracyChoice& choice) {
    return &choice == wavelengthChoice(block) || &choice == rayChoice(block);
}

} // namespace patina
