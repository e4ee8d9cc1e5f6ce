// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "background/worker.h"
#include "docks/dock_context.h"
#include "docks/measure_end.h"
#include "document/document_state.h"
#include "library/read_blocks.h"
#include "measure/cost/effect_cost.h"
#include "render/surfaces/object_rows.h"

class QLabel;
class QProgressBar;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace patina {

/// Lists the effects of the current object and its scene: which are in the shader or why not, what
/// each costs, and a switch that takes it out of the views.
class EffectsDock : public QWidget {
    Q_OBJECT

  public:
    explicit EffectsDock(const DockContext& context);

    /// Measures what the effects cost; nothing happens while that is going on.
    void measure();
    bool isMeasuring() const { return !measurement_.isIdle(); }

    QSize sizeHint() const override;

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Holds what costs were measured of.
    struct Measured {
        Scene scene;
        int object = -1;
        Side side = Side::A;
        KnownBlocks blocks; ///< of that scene
        EffectCosts costs{};
        MeasureEnd end = false;
    };

    void layOut();
    void connectParts();
    void watchViews();
    void updateRows();
    void fill();
    void fillRow(QTreeWidgetItem* item, const EffectRow& row);
    void fillCost(QTreeWidgetItem* item, const EffectRow& row);
    QString labelOf(const std::string& effect) const;
    QString whyOf(const EffectRow& row) const;
    QTreeWidgetItem* parentOf(const EffectRow& row) const;
    void showState();
    QString totalText() const;
    bool isStale() const;
    QString whyStale() const;
    KnownImages images() const;
    double aspect() const; ///< of the view that shows the current object
    MeasureEnd meter(const EffectCostMeter::Subject& subject, Worker::Control& control);
    void finish(const MeasureEnd& end);
    void toggle(QTreeWidgetItem* item);

    Document& document_;
    MeshLibrary& library_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    EffectSwitches& switches_;
    CompareArea& views_;
    std::vector<EffectRow> rows_;
    std::optional<Measured> measured_;  ///< the last costs, or what they are being measured of
    bool costsAreFresh_ = false;        ///< as of the last fill()
    std::vector<std::string> shownOff_; ///< effects that were off then
    QTimer settle_;                     ///< changes of the document are gathered
    QToolButton* start_;
    QToolButton* cancel_;
    QToolButton* allOn_;
    QProgressBar* progress_;
    QLabel* total_;
    QTreeWidget* list_;
    Worker measurement_;
};

} // namespace patina
