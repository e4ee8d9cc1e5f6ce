// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace patina {

/// Keeps a menu open while things in it are switched on and off.
class CheckMenu : public QMenu {
    Q_OBJECT

  public:
    using QMenu::QMenu;

    QAction* addCheck(const QString& text, bool isOn);

  protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    bool switched(QAction* action);
};

} // namespace patina
