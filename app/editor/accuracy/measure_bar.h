// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

/// The row above what is measured: start, stop, progress, a sentence, export.
class MeasureBar : public QWidget {
    Q_OBJECT

  public:
    /// `what` says what starting measures; `endings` are those of the files it can be exported to.
    MeasureBar(const QString& what, const QStringList& endings, QWidget* parent = nullptr);

    void setProgress(double share); ///< 0 .. 1
    void setRunning(bool running);
    void setStartable(bool startable);
    void setExportable(bool exportable);
    void setText(const QString& text);
    QString text() const;

  Q_SIGNALS:
    void startWished();
    void stopWished();
    void exportWished(QString ending);

  private:
    QToolButton* start_;
    QToolButton* stop_;
    QProgressBar* progress_;
    QLabel* text_;
    QToolButton* export_;
};

} // namespace patina
