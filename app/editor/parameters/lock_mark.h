// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace patina {

/// The mark of a locked value: a padlock; pressing it frees the value.
class LockMark : public QAbstractButton {
    Q_OBJECT

  public:
    explicit LockMark(QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace patina
