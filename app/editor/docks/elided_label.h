// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace patina {

/// Is a line of text that never widens its parent: text without room is elided and shown by the
/// tool tip. With word wrap nothing is elided unless there is a limit of lines.
class ElidedLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    void setElidedText(const QString& text);

    /// Wraps the text into so many lines at most, of which the last one is elided.
    void setMaxLines(int lines);

    /// Returns the text as it is drawn now, perhaps elided.
    QString shown() const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString wrapped() const;

    int maxLines_ = 0; ///< is 0 where there is no limit
};

} // namespace patina
