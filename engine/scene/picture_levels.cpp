// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_levels.h"

#include <fmt/format.h>

#include "catalog/suggestion.h"
#include "scene/picture_choice_text.h"

namespace patina {
namespace {

constexpr std::string_view prefix = "picture.";

Result<void> choose(Scene& scene, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    const std::string_view id = assignment.substr(prefix.size(), equals - prefix.size());
    const PictureChoiceText* text = pictureChoiceText(id);
    std::vector<std::string> known;
    if (equals == std::string_view::npos || text == nullptr) {
        for (const PictureChoiceText& each : pictureChoiceTexts()) {
            known.emplace_back(each.id);
        }
        return failure(std::string("the picture has no such choice"), oneOf(id, known));
    }
    const std::string_view word = assignment.substr(equals + 1);
    if (const auto level = text->level(word)) {
        scene.accuracy.choose(text->choice, *level);
        return {};
    }
    for (const PictureChoiceText::Level& level : text->levels) {
        known.emplace_back(level.id);
    }
    return failure(fmt::format("picture.{}: \"{}\" is not a level of it", text->id, word),
                   oneOf(word, known));
}

} // namespace

bool isOfPicture(const std::string& assignment) {
    return assignment.starts_with(prefix);
}

Result<void> choosePictureAccuracy(Scene& scene, const std::string& assignment) {
    return choose(scene, assignment);
}

} // namespace patina
