// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

/// Is a widget with a plot of its own colours and fonts, which is drawn again when the look
/// changes.
class PlotWidget : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

  protected:
    virtual void draw() = 0;
    void changeEvent(QEvent* event) override;
};

} // namespace patina
