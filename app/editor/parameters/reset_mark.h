// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace patina {

/// The mark of a changed value: a small round arrow; pressing it resets the value.
class ResetMark : public QAbstractButton {
    Q_OBJECT

  public:
    explicit ResetMark(QWidget* parent = nullptr);

    QSize sizeHint() const override;

  protected:
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace patina
