// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QStyledItemDelegate>

namespace patina {

/// A level that a way to compute something takes, by name, and of which choice.
struct WayPart {
    QString choice;
    QString level;
};

/// "Render scale: Half + Fog: Per vertex".
QString wayText(const std::vector<WayPart>& parts);

/// The same where `fits` says for which texts there is room: names of choices, which many ways have
/// in common, are cut before those of levels, which tell ways apart.
QString fittingWay(const std::vector<WayPart>& parts,
                   const std::function<bool(const QString&)>& fits);

/// Writes a row's way as wide as its column is.
class WayDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// What is kept in this role: choices and levels in turn, as a list of texts.
    static constexpr int partsRole = Qt::UserRole + 2;
    static QStringList partsData(const std::vector<WayPart>& parts);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace patina
