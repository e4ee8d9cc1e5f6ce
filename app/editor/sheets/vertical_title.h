// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

/// Shows a line of text that reads from bottom to top. It is no wider than a line is high, and
/// hidden without a text.
class VerticalTitle : public QWidget {
    Q_OBJECT

  public:
    explicit VerticalTitle(QWidget* parent = nullptr);

    void setText(const QString& text);

    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString text_;
};

} // namespace patina
