// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStatusBar>
#include <QTimer>

#include "document/document.h"
#include "resources/environment_library.h"
#include "resources/mesh_library.h"
#include "resources/texture_library.h"
#include "session/message_log.h"
#include "viewport/viewport.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace patina {

/// The model, the effects in the shader, and the frame's time with how it was measured; what is
/// loading; and how many messages there are.
class StatusLine : public QStatusBar {
    Q_OBJECT

  public:
    StatusLine(Document& document, MeshLibrary& meshes, TextureLibrary& textures,
               EnvironmentLibrary& environments, MessageLog& messages, QWidget* parent = nullptr);

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
    void makeLoadingRow();
    void showFrame();
    void showLoading(const QString& file, float share);
    void showFinding(const QString& mesh, float share);
    void showProgress(const QString& text, float share);
    void hideLoading();
    void showSamples();
    void showBadge();
    bool isLoading() const;

    Document& document_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    MessageLog& messages_;
    Viewport* viewport_ = nullptr;
    QTimer settle_;
    QLabel* model_;
    QLabel* effects_;
    QLabel* comparison_;
    QLabel* samples_;
    QLabel* time_;
    QProgressBar* progress_;
    QToolButton* cancel_;
    QToolButton* badge_;
    QToolButton* switched_; ///< says that effects are switched off
};

} // namespace patina
