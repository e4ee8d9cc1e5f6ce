// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QStyledItemDelegate>

namespace patina {

/// Holds the label of a chosen level and the label of its choice.
struct SettingPart {
    QString choice;
    QString level;
};

/// Returns "Render scale: Half + Fog: Per vertex".
QString settingText(const std::vector<SettingPart>& parts);

/// Returns settingText() shortened until `fits` accepts it. Cuts names of choices, which many rows
/// have in common, before those of levels, and leaves choices out if nothing else fits.
QString fittingSetting(const std::vector<SettingPart>& parts,
                       const std::function<bool(const QString&)>& fits);

/// Writes the levels of a row so that they fit the width of its column.
class SettingDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// Holds choices and levels by turns as a list of texts; see partsData().
    static constexpr int partsRole = Qt::UserRole + 2;
    static QStringList partsData(const std::vector<SettingPart>& parts);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace patina
