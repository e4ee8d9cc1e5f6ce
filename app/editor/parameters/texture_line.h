// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include "parameters/parameter_source.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace patina {

/// Shows the image on a value in one line: a small picture, whether it counts, its name, and
/// buttons for its settings and to remove it. Without an image there is only a button that asks for
/// one.
class TextureLine : public QWidget {
    Q_OBJECT

  public:
    TextureLine(const QString& valueName, QWidget* parent);

    void present(const std::optional<TextureUse>& use, const TexturePreview& preview);
    bool isBound() const { return isBound_; }

    /// Lets vertex colours be chosen in place of a file.
    void offerVertexColors();

    QToolButton* settingsButton() const { return settings_; }

  Q_SIGNALS:
    void chooseWished();
    void vertexColorsWished();
    void settingsWished();
    void removeWished();
    void enabledWished(bool enabled);
    void allowWished();

  protected:
    /// Draws the icon again, which has the palette's colour.
    void changeEvent(QEvent* event) override;

  private:
    QToolButton* button(const QString& text, const QString& toolTip);
    void showName(const TextureUse& use, const QString& problem);
    void showPreview();

    QString valueName_;
    QToolButton* choose_;
    QCheckBox* enabled_;
    QLabel* name_;
    QToolButton* allow_;
    QToolButton* settings_;
    QToolButton* remove_;
    bool isPresented_ = false;
    std::optional<TextureUse> use_;
    QString problem_;
    bool isBound_ = false;
    QImage image_;
    bool isMissing_ = false;
    bool counts_ = true;
};

} // namespace patina
