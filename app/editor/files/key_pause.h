// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QDialog;

namespace patina {

/// Keeps keys from a dialog until it has been seen for half a second: what is typed while a
/// question opens was meant for what lay there before.
class KeyPause : public QObject {
  public:
    static constexpr int pauseMs = 500;

    /// Belongs to the dialog, which has its buttons already and is not shown yet.
    explicit KeyPause(QDialog& dialog);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool isSeen_ = false;
};

} // namespace patina
