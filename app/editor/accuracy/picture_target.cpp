// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/picture_target.h"

#include <utility>

#include <QCoreApplication>

#include "document/compare_edits.h"
#include "document/comparison.h"
#include "document/picture_edits.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("PictureTarget", text);
}

} // namespace

Scene PictureTarget::withLevels(const std::vector<Choice>& choices,
                                const ChosenLevels& levels) const {
    ChosenFrame frame{document_.ownScene(document_.selection().side()), View()};
    if (!frame.scene.objects.empty()) {
        choose(frame, 0, choices, levels, document_.catalog());
    }
    return std::move(frame.scene);
}

std::vector<Choice> PictureTarget::choices() const {
    const Scene scene = document_.ownScene(document_.selection().side());
    return scene.objects.empty() ? std::vector<Choice>()
                                 : choicesOfPicture(scene, document_.catalog());
}

ChosenLevels PictureTarget::levels(const std::vector<Choice>& choices) const {
    return levelsOfPicture(document_.ownScene(document_.selection().side()), choices,
                           document_.catalog());
}

MeasuredSubject PictureTarget::subject() const {
    return subjectOf(withLevels(choices(), {}), document_.selection().object(),
                     document_.catalog());
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
        showOwnPicture(document_);
        setPicture(document_, wanted);
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
