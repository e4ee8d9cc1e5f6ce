// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

/// Represents a warning triangle that says in its tooltip what is unusual. Empty text: nothing to
/// see.
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
