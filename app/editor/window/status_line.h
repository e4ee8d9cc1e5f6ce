// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QStatusBar>
#include <QTimer>

#include "document/document.h"
#include "session/message_log.h"
#include "viewport/viewport.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

class TaskPopup;

/// The model, the effects in the shader, and the frame's time with how it was measured; what takes
/// long; and how many messages there are.
class StatusLine : public QStatusBar {
    Q_OBJECT

  public:
    StatusLine(Document& document, MessageLog& messages, QWidget* parent = nullptr);

    /// Whose frames are told about.
    void setViewport(Viewport* viewport);

    /// Sets how many effects the views do not show because they are switched off.
    void setSwitchedOff(int effects);

    /// How far the sides of a comparison are apart; empty: nothing is known of that.
    void setComparison(const QString& text, const QString& details);

  Q_SIGNALS:
    void messagesWished();
    void effectsWished();

  private:
    void makeTaskRow();
    void showFrame();
    void showTasks();
    void listTasks();
    void showSamples();
    void showBadge();

    Document& document_;
    MessageLog& messages_;
    Viewport* viewport_ = nullptr;
    QTimer settle_;
    QLabel* model_;
    QLabel* effects_;
    QLabel* comparison_;
    QLabel* samples_;
    QLabel* time_;
    QProgressBar* progress_;
    QToolButton* tasks_; ///< says how many there are
    QPointer<TaskPopup> popup_;
    QToolButton* badge_;
    QToolButton* switched_; ///< says that effects are switched off
};

} // namespace patina
