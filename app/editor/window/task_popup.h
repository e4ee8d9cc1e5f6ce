// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QFrame>

#include "background/long_tasks.h"

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace patina {

/// Lists tasks that take long: a line each with its name, its progress, and a button that stops it.
/// It closes when there is nothing left to list.
class TaskPopup : public QFrame {
    Q_OBJECT

  public:
    explicit TaskPopup(LongTasks& tasks, QWidget* parent);

    /// Shows it with its lower right corner at a place on the screen.
    void showAt(const QPoint& place);

  private:
    struct Line {
        QWidget* widget;
        QLabel* name;
        QLabel* doing;
        QProgressBar* share;
        QToolButton* cancel;
    };

    void follow();
    Line& line(quint64 number, const QString& name);

    LongTasks& tasks_;
    QVBoxLayout* column_;
    std::map<quint64, Line> lines_;
    QPoint corner_;
};

} // namespace patina
