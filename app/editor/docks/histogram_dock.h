// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "docks/dock_context.h"

class QComboBox;
class QLabel;

namespace patina {

class HistogramPlot;
class SideView;

/// Shows how bright the pixels of the active view are, as the screen shows them or in stops of
/// light, and how many are clipped. It reads the picture that is there, once nothing has changed
/// for a moment; no frame is drawn for it.
class HistogramDock : public QWidget {
    Q_OBJECT

  public:
    explicit HistogramDock(const DockContext& context);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void follow(SideView* view);
    void readSoon();
    void read();
    void readLevels();
    void readStops();

    Document& document_;
    CompareArea& views_;
    QComboBox* scale_;
    HistogramPlot* plot_;
    QLabel* text_;
    QTimer rest_;
};

} // namespace patina
