// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/compare_look.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace patina {
namespace {

/// Seconds that each picture is shown. No more than three flashes a second are safe to look at
/// (WCAG 2.3.1).
constexpr double minBlink = 0.34;
constexpr double maxBlink = 2.0;

constexpr CompareModeRow modes[] = {
    {CompareMode::SideBySide, "side", QT_TRANSLATE_NOOP("Compare", "Side by side"),
     QT_TRANSLATE_NOOP("Compare", "A beside B")},
    {CompareMode::Wipe, "wipe", QT_TRANSLATE_NOOP("Compare", "Wipe"),
     QT_TRANSLATE_NOOP("Compare", "A on one side of a line and B on the other: drag the line, turn "
                                  "it by its knob"),
     &CompareLook::wipe, QT_TRANSLATE_NOOP("Compare", "Place of the line")},
    {CompareMode::Flip, "flip", QT_TRANSLATE_NOOP("Compare", "Flip"),
     QT_TRANSLATE_NOOP("Compare", "The side that is edited; the other one while Space is held")},
    {CompareMode::Onion, "onion", QT_TRANSLATE_NOOP("Compare", "Onion"),
     QT_TRANSLATE_NOOP("Compare", "B over A, as opaque as the slider says"), &CompareLook::onion,
     QT_TRANSLATE_NOOP("Compare", "Opacity of B")},
    {CompareMode::Blink, "blink", QT_TRANSLATE_NOOP("Compare", "Blink"),
     QT_TRANSLATE_NOOP("Compare", "A and B in turns"), &CompareLook::blink,
     QT_TRANSLATE_NOOP("Compare", "Seconds for each"), minBlink, maxBlink},
    {CompareMode::Difference, "difference", QT_TRANSLATE_NOOP("Compare", "Difference"),
     QT_TRANSLATE_NOOP("Compare", "How far A and B are apart, alone")},
};

QString compareText(const char* text) {
    return QCoreApplication::translate("Compare", text);
}

} // namespace

QString CompareModeRow::shownLabel() const {
    return compareText(label);
}

QString CompareModeRow::shownDoc() const {
    return compareText(doc);
}

QString CompareModeRow::shownAmountLabel() const {
    return compareText(amountLabel);
}

bool CompareModeRow::isComposed() const {
    return mode != CompareMode::SideBySide && mode != CompareMode::Difference;
}

std::span<const CompareModeRow> compareModes() {
    return modes;
}

const CompareModeRow& rowOf(CompareMode mode) {
    return *std::ranges::find(modes, mode, &CompareModeRow::mode);
}

CompareMode compareModeCalled(const QString& id) {
    const auto found = std::ranges::find_if(
        modes, [&](const CompareModeRow& row) { return id == QLatin1String(row.id); });
    return found == std::end(modes) ? CompareMode::SideBySide : found->mode;
}

CompareLook withAmount(CompareLook look, double share) {
    const CompareModeRow& row = rowOf(look.mode);
    if (row.amount != nullptr) {
        look.*row.amount = row.min + std::clamp(share, 0.0, 1.0) * (row.max - row.min);
    }
    return look;
}

double amountOf(const CompareLook& look) {
    const CompareModeRow& row = rowOf(look.mode);
    return row.amount == nullptr ? 0.0 : (look.*row.amount - row.min) / (row.max - row.min);
}

double wrappedAngle(double degrees) {
    return std::isfinite(degrees) ? std::remainder(degrees, 360.0) : 0.0;
}

} // namespace patina
