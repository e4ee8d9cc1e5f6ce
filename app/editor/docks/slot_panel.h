// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <QGroupBox>

namespace patina {

class BlockChooser;
class Document;
class DocumentForm;
class TextureLibrary;

/// Chooses what fills a slot of the active material's model, and edits its values. Hidden where the
/// model has no such slot; what was chosen is then kept in the material.
class SlotPanel : public QGroupBox {
    Q_OBJECT

  public:
    /// `kind` outlives the panel, as those of the table do.
    SlotPanel(Document& document, TextureLibrary& textures, std::string_view kind,
              const QString& title, QWidget* parent = nullptr);

    DocumentForm& form() const { return *form_; }

  private:
    void update();

    Document& document_;
    std::string_view kind_;
    BlockChooser* chooser_;
    DocumentForm* form_;
};

} // namespace patina
