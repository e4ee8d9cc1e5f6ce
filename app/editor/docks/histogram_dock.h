// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "core/image.h"
#include "docks/dock_context.h"

class QComboBox;
class QLabel;

namespace patina {

class HistogramPlot;
class SideView;

/// Shows how bright the pixels of the active view are, as the screen shows them or in stops of
/// light, and how many are clipped. It reads the picture that is there, once nothing has changed
/// for a moment; a frame is drawn for it only where a view that rests has given its picture back
/// when the panel is shown or the scale chosen.
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
    void showLevels(const Image& display);
    void showStops(const Image& linear);

    Document& document_;
    CompareArea& views_;
    QComboBox* scale_;
    HistogramPlot* plot_;
    QLabel* text_;
    QTimer rest_;
    bool asks_ = false; ///< for a frame, where there is no picture to read
    bool isOwed_ = false; ///< the view was drawing when it was to be read
};

} // namespace patina
