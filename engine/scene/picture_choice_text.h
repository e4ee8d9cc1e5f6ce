// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/picture_accuracy.h"

namespace patina {

/// Holds what a choice of the picture's accuracy is called: in scene files, on the command line, in
/// forms and on charts.
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
    std::span<const Level> levels; ///< the exact one first

    /// Returns the number of a level by its id.
    std::optional<std::size_t> level(std::string_view levelId) const;
};

/// Returns the texts of all choices, in the order in which they are shown.
std::span<const PictureChoiceText> pictureChoiceTexts();

/// Null where there is none of this id.
const PictureChoiceText* pictureChoiceText(std::string_view id);

} // namespace patina
