// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/picture_target.h"

#include <utility>

#include <QCoreApplication>

#include "document/comparison.h"
#include "document/picture_parameters.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("PictureTarget", text);
}

/// The values of a block that differ from those that are there.
void setValues(Document& document, const BlockPath& path, const BlockValues& wanted) {
    for (const auto& [id, value] : wanted.parameters) {
        document.setValue(path, id, value);
    }
}

/// Brings what choices of the picture change, and nothing else, from `wanted` into the document.
void takePicture(Document& document, const Scene& wanted) {
    const BlockPath scenePath = document.currentPath(settings::scene);
    for (const Parameter& parameter : pictureAccuracyParameters()) {
        if (const auto level = pictureLevel(wanted, parameter.id)) {
            document.setValue(scenePath, parameter.id, *level);
        }
    }
    if (const BlockValues* transparency = wanted.part(kinds::transparency)) {
        document.setBlock(pathOf(kinds::transparency), transparency->id);
        setValues(document, pathOf(kinds::transparency), *transparency);
    }
    if (const BlockValues* environment = wanted.part(kinds::environment)) {
        setValues(document, document.currentPath(kinds::environment), *environment);
    }
    for (std::size_t i = 0; i < wanted.lights.size(); ++i) {
        if (const BlockValues* shadow = wanted.lights[i].part(kinds::shadows)) {
            setValues(document, pathOf(kinds::shadows, static_cast<int>(i)), *shadow);
        }
    }
}

} // namespace

Scene PictureTarget::withLevels(const std::vector<Choice>& choices,
                                const ChosenLevels& levels) const {
    ChosenFrame frame{document_.ownScene(document_.activeSide()), View()};
    if (!frame.scene.objects.empty()) {
        choose(frame, 0, choices, levels, document_.catalog());
    }
    return std::move(frame.scene);
}

std::vector<Choice> PictureTarget::choices() const {
    const Scene scene = document_.ownScene(document_.activeSide());
    return scene.objects.empty() ? std::vector<Choice>()
                                 : choicesOfPicture(scene, document_.catalog());
}

ChosenLevels PictureTarget::levels(const std::vector<Choice>& choices) const {
    return levelsOfPicture(document_.ownScene(document_.activeSide()), choices,
                           document_.catalog());
}

MeasuredSubject PictureTarget::subject() const {
    return subjectOf(withLevels(choices(), {}), document_.currentObject(), document_.catalog());
}

void PictureTarget::apply(const std::vector<Choice>& choices, const ChosenLevels& levels,
                          const QString& label) {
    const Scene wanted = withLevels(choices, levels);
    const bool isSo =
        levelsOfPicture(wanted, choices, document_.catalog()) == this->levels(choices);
    if (isSo && overlaidPicture(document_.state(), Side::A) == nullptr) {
        return;
    }
    document_.editAsOneStep(label, [&] {
        document_.showOwnPicture();
        takePicture(document_, wanted);
    });
}

void PictureTarget::compare(const std::vector<Choice>& choices, const ChosenLevels& levels) {
    views_.setDifferenceWanted(true);
    comparison_.previewPictures(withLevels(choices, {}), withLevels(choices, levels),
                                tr("Compare with exact"));
}

QString PictureTarget::measureText() const {
    return tr("Measure the time and the error of every way to draw this scene's picture");
}

QString PictureTarget::noChoicesText() const {
    return tr("There is nothing to draw.");
}

} // namespace patina
