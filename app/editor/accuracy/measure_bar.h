// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;
class QProgressBar;
class QToolButton;

namespace patina {

class ElidedLabel;

/// Is the row above what a page measured: start, stop, progress, a sentence, export.
class MeasureBar : public QWidget {
    Q_OBJECT

  public:
    /// `what` says what starting measures; `endings` are the suffixes of the files for export.
    MeasureBar(const QString& what, const QStringList& endings, QWidget* parent = nullptr);

    /// Puts a button before the export.
    void addButton(QToolButton* button);
    /// Writes other words than "Measure" on the button that starts.
    void setStartText(const QString& text);
    /// Lets the sentence wrap, and keeps room for two lines from now on.
    void giveTwoLines();

    void setProgress(double share); ///< 0 .. 1
    void setRunning(bool running);
    /// Lets the artist start a measurement. `whyNot` says what has to end first; empty if nothing
    /// has to.
    void setStartable(bool startable, const QString& whyNot);
    void setExportable(bool exportable);
    void setText(const QString& text);
    QString text() const;

  Q_SIGNALS:
    void startWished();
    void stopWished();
    void exportWished(QString ending);

  private:
    QString what_; ///< says what starting measures
    QHBoxLayout* row_;
    QToolButton* start_;
    QToolButton* stop_;
    QProgressBar* progress_;
    ElidedLabel* text_;
    QToolButton* export_;
};

} // namespace patina
