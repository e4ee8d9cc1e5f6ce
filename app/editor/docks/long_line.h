// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace patina {

/// A line of text that never widens what it stands in: what has no room is left out behind dots and
/// told by the tooltip. One that wraps its words leaves nothing out.
class LongLine : public QLabel {
    Q_OBJECT

  public:
    explicit LongLine(QWidget* parent = nullptr);

    void tell(const QString& text);

    /// Returns what is drawn of the text now.
    QString shown() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace patina
