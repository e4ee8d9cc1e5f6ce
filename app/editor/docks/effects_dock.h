// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "docks/dock_context.h"
#include "docks/effect_measurement.h"
#include "render/surfaces/object_rows.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

class EffectList;
class FamilyChooser;

/// Shows the effects of the current object and its scene as its view has them, and measures what
/// they cost when it is asked to.
class EffectsDock : public QWidget {
    Q_OBJECT

  public:
    explicit EffectsDock(const DockContext& context);

    /// Measures what the effects cost; nothing happens while that is going on.
    void measure(EffectCostMeter::Options options = {});
    bool isMeasuring() const { return measurement_.isRunning(); }

    QSize sizeHint() const override;

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void layOut();
    void connectParts();
    void watchViews();
    void updateRows();
    void refresh();
    void showState();
    std::vector<EffectRow> currentRows() const;
    KnownImages images() const;
    double aspect() const;

    Document& document_;
    MeshLibrary& library_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    EffectSwitches& switches_;
    CompareArea& views_;
    EffectMeasurement measurement_;
    QTimer settle_; ///< gathers changes of the document
    QToolButton* start_;
    QToolButton* cancel_;
    QToolButton* allOn_;
    QToolButton* passes_; ///< opens the times of the frame's passes
    QProgressBar* progress_;
    QLabel* state_;
    FamilyChooser* family_;
    EffectList* list_;
};

} // namespace patina
