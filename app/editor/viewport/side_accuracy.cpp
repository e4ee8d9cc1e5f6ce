// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/side_accuracy.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

#include "material/blocks_in_use.h"

namespace patina {
namespace {

/// Each choice that is not exact, in words.
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

bool differInAccuracyAlone(Material a, const Material& b) {
    a.accuracy = b.accuracy;
    return a == b;
}

} // namespace

QString accuracyOfSide(const Document& document, Side side) {
    const Material* a = document.material(Side::A);
    const Material* b = document.material(Side::B);
    if (!document.isComparing() || a == nullptr || b == nullptr ||
        !differInAccuracyAlone(*a, *b)) {
        return {};
    }
    const QStringList ofA = cheapLevels(*a, document.catalog());
    const QStringList ofB = cheapLevels(*b, document.catalog());
    if (ofA == ofB) {
        return {};
    }
    const QStringList& names = side == Side::A ? ofA : ofB;
    return names.isEmpty() ? QCoreApplication::translate("SideView", "Exact")
                           : names.join(QStringLiteral(" + "));
}

} // namespace patina
