// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <QGroupBox>

namespace patina {

class BlockChooser;
class Document;
class DocumentForm;
class TextureLibrary;

/// Chooses the block in a slot of the active material's model and edits its values. It is hidden if
/// the model has no such slot; the material then keeps what was chosen.
class SlotPanel : public QGroupBox {
    Q_OBJECT

  public:
    /// Keeps a view of `kind`, which has to outlive the panel, as the constants in `kinds` do.
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
