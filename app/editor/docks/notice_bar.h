// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QFrame>

class QLabel;
class QToolButton;

namespace patina {

/// Is a line in a panel that says what is going on there, with up to two buttons. It is hidden
/// while there is nothing to say.
class NoticeBar : public QFrame {
    Q_OBJECT

  public:
    struct Action {
        QString text;
        QString toolTip;
        std::function<void()> run;
    };

    explicit NoticeBar(QWidget* parent = nullptr);

    void say(const QString& text, const std::vector<Action>& actions = {});
    void clear();
    QString text() const;

  private:
    QLabel* label_;
    std::vector<QToolButton*> buttons_;
    std::vector<Action> actions_;
};

} // namespace patina
