// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QDialog;

namespace patina {

/// Keeps keys from a dialog until it has been visible for half a second, since what is typed while
/// a dialog opens was meant for another window.
class KeyPause : public QObject {
  public:
    static constexpr int pauseMs = 500;

    /// Becomes a child of the dialog, which has its buttons already and is not shown yet.
    explicit KeyPause(QDialog& dialog);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isSeen_ = false;
};

} // namespace patina
