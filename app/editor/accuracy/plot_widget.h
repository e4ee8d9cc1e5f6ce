// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

/// Is a widget whose plot has its own colours and fonts, and is drawn again when the palette or the
/// font changes.
class PlotWidget : public QWidget {
    Q_OBJECT

  public:
    using QWidget::QWidget;

  protected:
    virtual void draw() = 0;
    void changeEvent(QEvent* event) override;
};

} // namespace patina
