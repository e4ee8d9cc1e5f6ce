// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/side_accuracy.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

#include "material/blocks_in_use.h"
#include "measure/choice/choices.h"

namespace patina {
namespace {

/// Returns each accuracy choice of a material that is not exact, as "choice: level".
QStringList cheapLevels(const Material& material, const Catalog& catalog) {
    QStringList names;
    for (const Block* block : blocksInUse(material, catalog)) {
        for (const AccuracyChoice& choice : block->accuracy) {
            const auto chosen = material.accuracy.find(choice.id);
            const auto level = std::ranges::find_if(choice.values, [&](const EnumValue& value) {
                return chosen != material.accuracy.end() && value.id == chosen->second;
            });
            if (level != choice.values.end() && level != choice.values.begin()) {
                names << QStringLiteral("%1: %2").arg(QString::fromStdString(choice.label),
                                                      QString::fromStdString(level->label));
            }
        }
    }
    names.removeDuplicates(); // the model and a part may share a choice
    return names;
}

QString levelName(const Choice& choice, const std::string& level) {
    const ChoiceLevel* known = choice.level(level);
    return QStringLiteral("%1: %2").arg(
        QString::fromStdString(choice.label),
        QString::fromStdString(known != nullptr ? known->label : level));
}

/// Returns each choice of how a scene's picture is drawn that is not exact.
QStringList cheapLevels(const Scene& scene, const Catalog& catalog) {
    const std::vector<Choice> choices = choicesOfPicture(scene, catalog);
    const ChosenLevels levels = levelsOfPicture(scene, choices, catalog);
    QStringList names;
    for (const Choice& choice : choices) {
        if (const auto level = levels.find(choice.id); level != levels.end()) {
            names << levelName(choice, level->second);
        }
    }
    return names;
}

QString textOf(const QStringList& names) {
    return names.isEmpty() ? QCoreApplication::translate("SideView", "Exact")
                           : names.join(QStringLiteral(" + "));
}

bool differInAccuracyAlone(Material a, const Material& b) {
    a.accuracy = b.accuracy;
    return a == b;
}

} // namespace

QString accuracyOfSide(const Document& document, Side side) {
    const DocumentState& state = document.state();
    if (document.shownSides() > 2) {
        return {};
    }
    if (state.second && state.picture && !hasSecondMaterial(state)) {
        return textOf(cheapLevels(document.scene(side), document.catalog()));
    }
    const Material* a = document.material(Side::A);
    const Material* b = document.material(Side::B);
    if (!document.isComparing() || a == nullptr || b == nullptr || !differInAccuracyAlone(*a, *b)) {
        return {};
    }
    const QStringList ofA = cheapLevels(*a, document.catalog());
    const QStringList ofB = cheapLevels(*b, document.catalog());
    if (ofA == ofB) {
        return {};
    }
    return textOf(side == Side::A ? ofA : ofB);
}

} // namespace patina
