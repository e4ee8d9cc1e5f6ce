// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/picture_accuracy_file.h"

#include <vector>

#include <fmt/format.h>

#include "catalog/suggestion.h"
#include "scene/picture_choice_text.h"

namespace patina {
namespace {

constexpr const char* key = "accuracy";

Error unknownLevel(const JsonReader& reader, const PictureChoiceText& text,
                   const std::string& word) {
    std::vector<std::string> known;
    for (const PictureChoiceText::Level& level : text.levels) {
        known.emplace_back(level.id);
    }
    return reader.document().error(
        reader.pointer(text.id),
        fmt::format("\"{}\" is no level of it; the default is used", word), oneOf(word, known));
}

Error unknownChoice(const JsonReader& reader, const std::string& word) {
    std::vector<std::string> known;
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        known.emplace_back(text.id);
    }
    return reader.document().error(
        reader.pointer(word), fmt::format("\"{}\" is no accuracy choice of the picture", word),
        oneOf(word, known));
}

} // namespace

void readPictureAccuracy(JsonReader& file, Scene& scene, Errors& notes) {
    JsonReader reader = file.child(key);
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        std::string word;
        reader.read(text.id, word);
        if (const auto level = text.level(word)) {
            scene.accuracy.choose(text.choice, *level);
        } else if (!word.empty()) {
            notes.push_back(unknownLevel(reader, text, word));
        }
    }
    const nlohmann::json unknown = reader.unknown();
    for (const auto& item : unknown.items()) {
        notes.push_back(unknownChoice(reader, item.key()));
    }
    if (unknown.empty()) {
        scene.unknown.erase(key);
    } else {
        scene.unknown[key] = unknown;
    }
}

void writePictureAccuracy(nlohmann::json& file, const PictureAccuracy& accuracy) {
    static const PictureAccuracy always;
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        const std::size_t level = accuracy.level(text.choice);
        if (level != always.level(text.choice)) {
            file[key][text.id] = text.levels[level].id;
        }
    }
}

} // namespace patina
