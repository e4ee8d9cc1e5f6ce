// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/setting_delegate.h"

#include <algorithm>

#include <QApplication>
#include <QStyle>

namespace patina {
namespace {

/// Writes the parts with at most `maxLetters` letters of each choice; 0 leaves choices out.
QString withShortChoices(const std::vector<SettingPart>& parts, qsizetype maxLetters) {
    QStringList names;
    for (const SettingPart& part : parts) {
        const QString choice = part.choice.size() <= maxLetters
                                   ? part.choice
                                   : part.choice.left(maxLetters).trimmed() + QStringLiteral("…");
        names << (maxLetters > 0 ? QStringLiteral("%1: %2").arg(choice, part.level) : part.level);
    }
    return names.join(QStringLiteral(" + "));
}

qsizetype longestChoice(const std::vector<SettingPart>& parts) {
    qsizetype longest = 0;
    for (const SettingPart& part : parts) {
        longest = std::max(longest, part.choice.size());
    }
    return longest;
}

std::vector<SettingPart> partsOf(const QStringList& texts) {
    std::vector<SettingPart> parts;
    for (qsizetype i = 0; i + 1 < texts.size(); i += 2) {
        parts.push_back({texts[i], texts[i + 1]});
    }
    return parts;
}

const QStyle& styleOf(const QStyleOptionViewItem& option) {
    return option.widget != nullptr ? *option.widget->style() : *QApplication::style();
}

/// Returns the width for an item's text in pixels, without the margins of the style.
int roomOf(const QStyleOptionViewItem& option) {
    const QStyle& style = styleOf(option);
    const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, &option, option.widget) + 1;
    return style.subElementRect(QStyle::SE_ItemViewItemText, &option, option.widget).width() -
           2 * margin;
}

} // namespace

QString settingText(const std::vector<SettingPart>& parts) {
    return withShortChoices(parts, longestChoice(parts));
}

QString fittingSetting(const std::vector<SettingPart>& parts,
                       const std::function<bool(const QString&)>& fits) {
    constexpr qsizetype minLetters = 3; // shorter names of choices say nothing
    for (qsizetype maxLetters = longestChoice(parts); maxLetters >= minLetters; --maxLetters) {
        if (QString text = withShortChoices(parts, maxLetters); fits(text)) {
            return text;
        }
    }
    return withShortChoices(parts, 0);
}

QStringList SettingDelegate::partsData(const std::vector<SettingPart>& parts) {
    QStringList texts;
    for (const SettingPart& part : parts) {
        texts << part.choice << part.level;
    }
    return texts;
}

void SettingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    QStyleOptionViewItem shown = option;
    initStyleOption(&shown, index);
    if (const auto parts = partsOf(index.data(partsRole).toStringList()); !parts.empty()) {
        const int room = roomOf(shown);
        shown.text = fittingSetting(parts, [&shown, room](const QString& text) {
            return shown.fontMetrics.horizontalAdvance(text) <= room;
        });
    }
    styleOf(shown).drawControl(QStyle::CE_ItemViewItem, &shown, painter, shown.widget);
}

} // namespace patina
