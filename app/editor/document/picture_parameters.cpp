// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/picture_parameters.h"

#include <string>

#include "scene/picture_choice_text.h"

namespace patina {

namespace {

constexpr std::string_view prefix = "picture.";

const PictureChoiceText* textOf(std::string_view parameterId) {
    return parameterId.starts_with(prefix) ? pictureChoiceText(parameterId.substr(prefix.size()))
                                           : nullptr;
}

Value levelOf(const PictureAccuracy& accuracy, const PictureChoiceText& text) {
    return std::string(text.levels[accuracy.level(text.choice)].id);
}

} // namespace

std::vector<Parameter> pictureAccuracyParameters() {
    std::vector<Parameter> parameters;
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        Parameter parameter;
        parameter.type = ParameterType::Enum;
        parameter.id = std::string(prefix) + text.id;
        parameter.label = text.label;
        parameter.doc = text.doc;
        parameter.group = "Accuracy";
        parameter.defaultValue = levelOf(PictureAccuracy(), text);
        parameter.compiled = Compiled::Yes;
        for (const PictureChoiceText::Level& level : text.levels) {
            parameter.values.push_back({level.id, level.label, level.doc});
        }
        parameters.push_back(std::move(parameter));
    }
    return parameters;
}

std::optional<Value> pictureLevel(const Scene& scene, std::string_view parameterId) {
    const PictureChoiceText* text = textOf(parameterId);
    return text == nullptr ? std::nullopt : std::optional(levelOf(scene.accuracy, *text));
}

void storePictureLevel(Scene& scene, std::string_view parameterId, const Value& value) {
    const PictureChoiceText* text = textOf(parameterId);
    const auto* word = std::get_if<std::string>(&value);
    if (text == nullptr || word == nullptr) {
        return;
    }
    if (const auto level = text->level(*word)) {
        scene.accuracy.choose(text->choice, *level);
    }
}

} // namespace patina
