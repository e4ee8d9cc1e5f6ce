// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheets/axis_row.h"

class QToolButton;

namespace patina {

/// Chooses what a sheet goes through, how large its cells are and what they say, and has the menu
/// of its file. It shows what it is given and asks for changes; it changes nothing itself.
class SheetControls : public QWidget {
    Q_OBJECT

  public:
    explicit SheetControls(QWidget* parent = nullptr);

    /// Shows a sheet and what its axes may be of; null while that is not known.
    void show(const Sheet& sheet, const AxisRow::Subject* subject);

  Q_SIGNALS:
    void wished(const patina::Sheet& sheet);
    void exampleWished(const QString& file);
    void openWished();
    void saveWished();
    void exportWished();

  private:
    QMenu* makeNumbersMenu();
    QMenu* makeSheetMenu();
    void fillExamples(QMenu& menu);
    void fillSizes();
    void connectParts();
    void wishX(const std::optional<SheetAxis>& axis);
    void wishY(const std::optional<SheetAxis>& axis);
    void wish(const std::function<void(Sheet&)>& change);

    Sheet sheet_;
    AxisRow* x_;
    AxisRow* y_;
    QComboBox* size_;
    QToolButton* numbers_;
    QToolButton* menu_;
};

/// Tells whether two axes go through the same, in whatever steps.
bool isSameAxis(const SheetAxis& a, const SheetAxis& b);

} // namespace patina
