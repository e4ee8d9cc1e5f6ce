// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

/// Shows a warning triangle whose tooltip says what is unusual; it is hidden while there is no
/// text.
class WarningMark : public QWidget {
    Q_OBJECT

  public:
    explicit WarningMark(QWidget* parent = nullptr);

    void setWarning(const QString& warning);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace patina
