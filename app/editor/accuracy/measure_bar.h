// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;
class QProgressBar;
class QToolButton;

namespace patina {

class LongLine;

/// The row above what is measured: start, stop, progress, a sentence, export.
class MeasureBar : public QWidget {
    Q_OBJECT

  public:
    /// `what` says what starting measures; `endings` are those of the files it can be exported to.
    MeasureBar(const QString& what, const QStringList& endings, QWidget* parent = nullptr);

    /// Puts a button before that of the export.
    void addButton(QToolButton* button);
    /// Long sentences take a second line, for which there is room from now on.
    void giveTwoLines();

    void setProgress(double share); ///< 0 .. 1
    void setRunning(bool running);
    /// `whyNot`: what has to end before it can be started; empty: nothing.
    void setStartable(bool startable, const QString& whyNot);
    void setExportable(bool exportable);
    void setText(const QString& text);
    QString text() const;

  Q_SIGNALS:
    void startWished();
    void stopWished();
    void exportWished(QString ending);

  private:
    QString what_; ///< starting measures
    QHBoxLayout* row_;
    QToolButton* start_;
    QToolButton* stop_;
    QProgressBar* progress_;
    LongLine* text_;
    QToolButton* export_;
};

} // namespace patina
