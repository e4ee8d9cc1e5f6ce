// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

class QLabel;

namespace patina {

class BlockChooser;
class Document;
class TextureLibrary;

/// Turns the active material's refraction on and off, chooses its kind and edits its values.
class RefractionPanel : public QGroupBox {
    Q_OBJECT

  public:
    RefractionPanel(Document& document, TextureLibrary& textures, QWidget* parent = nullptr);

  private:
    void update();

    Document& document_;
    BlockChooser* chooser_;
    QLabel* hint_;
};

} // namespace patina
