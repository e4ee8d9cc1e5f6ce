// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace patina::tests {

/// Presses a button of the next message box, and tells whether one came.
class Answer {
  public:
    explicit Answer(QMessageBox::StandardButton button) {
        timer_.setInterval(20);
        QObject::connect(&timer_, &QTimer::timeout, [this, button] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked_ = true;
                timer_.stop();
                box->button(button)->click();
            }
        });
        timer_.start();
    }

    bool wasAsked() const { return asked_; }

  private:
    QTimer timer_;
    bool asked_ = false;
};

} // namespace patina::tests
