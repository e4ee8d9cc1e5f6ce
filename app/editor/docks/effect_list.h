// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QTreeWidget>

#include "docks/effect_measurement.h"
#include "viewport/effect_switches.h"

namespace patina {

/// Lists effects with what each costs, why it is in or not, and a switch that takes it out of the
/// views.
class EffectList : public QTreeWidget {
    Q_OBJECT

  public:
    /// All outlive it.
    EffectList(const Document& document, EffectSwitches& switches,
               const EffectMeasurement& measurement, QWidget* parent = nullptr);

    /// Shows what is predicted for this family of graphics cards.
    void setFamily(const GpuFamily& family);

    /// Returns the height of so many rows and the header, in pixels.
    int heightOf(int rows) const;

    const std::vector<EffectRow>& rows() const { return rows_; }

    /// Tells whether these rows are shown with the switches and costs that there are now.
    bool shows(const std::vector<EffectRow>& rows) const;

    /// Shows the rows. The current row stays, and the place where the list is scrolled to.
    void setRows(std::vector<EffectRow> rows);

    /// Shows the same rows with the switches and costs that there are now.
    void refresh();

  private:
    QTreeWidgetItem* parentOf(const EffectRow& row) const;
    void fillRow(QTreeWidgetItem* item, const EffectRow& row) const;
    void fillCost(QTreeWidgetItem* item, const EffectRow& row) const;
    void fillPrediction(QTreeWidgetItem* item, const EffectRow& row) const;
    QString labelOf(const std::string& effect) const;
    QString reasonOf(const EffectRow& row) const;
    void toggle(QTreeWidgetItem* item);

    const Document& document_;
    EffectSwitches& switches_;
    const EffectMeasurement& measurement_;
    const GpuFamily* family_;
    std::vector<EffectRow> rows_;
    std::vector<std::string> shownOff_; ///< effects that were off when the rows were shown
    bool costsAreFresh_ = false;        ///< when the rows were shown
};

} // namespace patina
