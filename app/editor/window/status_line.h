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

/// Shows the model, the effects in the shader, and the frame's time with the method by which it was
/// measured; tasks that take long; and how many messages there are.
class StatusLine : public QStatusBar {
    Q_OBJECT

  public:
    StatusLine(Document& document, MessageLog& messages, QWidget* parent = nullptr);

    /// Sets the view whose frames are described; not null.
    void setViewport(Viewport* viewport);

    /// Sets how many effects the views do not show because they are switched off.
    void setSwitchedOff(int effects);

    /// Shows how far the sides of a comparison are apart, with `details` as the tool tip; hidden
    /// where `text` is empty.
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
    QToolButton* tasks_; ///< says how many tasks run
    QPointer<TaskPopup> popup_;
    QToolButton* badge_;
    QToolButton* switched_; ///< says that effects are switched off
};

} // namespace patina
