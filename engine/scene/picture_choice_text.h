// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/picture_accuracy.h"

namespace patina {

/// Holds the texts for a choice of the picture's accuracy: `id` is its name in scene files and on
/// the command line, the others are shown to users.
struct PictureChoiceText {
    struct Level {
        const char* id;
        const char* label;
        const char* doc;
    };

    PictureChoice choice;
    const char* id;
    const char* label;
    const char* doc;
    std::span<const Level> levels; ///< begin with the exact one

    /// Returns the number of a level by its id; nothing where there is none of this id.
    std::optional<std::size_t> level(std::string_view levelId) const;
};

/// Returns the texts of all choices, in the order in which they are shown.
std::span<const PictureChoiceText> pictureChoiceTexts();

/// Returns the texts of a choice by its id; null where there is none of this id.
const PictureChoiceText* pictureChoiceText(std::string_view id);

} // namespace patina
