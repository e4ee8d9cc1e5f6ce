// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <QGroupBox>

#include "catalog/block_kind.h"

class QBoxLayout;

namespace patina {

class BlockChooser;
class Document;
class DocumentForm;
class TextureLibrary;

/// Chooses the block of a kind in the material, the light or the scene that is worked on, and edits
/// its values. It is hidden where a model has no slot for the kind (the material then keeps what
/// was chosen) and where there is no light.
class PartPanel : public QGroupBox {
    Q_OBJECT

  public:
    /// Keeps a view of `kind`, which has to outlive the panel, as the table of kinds does.
    PartPanel(Document& document, TextureLibrary& textures, std::string_view kind,
              const QString& title, QWidget* parent = nullptr);

    DocumentForm& form() const { return *form_; }

  private:
    void update();
    bool isPossible() const;

    Document& document_;
    std::string_view kind_;
    BlockChooser* chooser_;
    DocumentForm* form_;
};

/// Adds a panel for each kind of part that such an owner may have and no dock has a panel of its
/// own for, under the kind's label: a new kind has one without any code.
void addPartPanels(QBoxLayout& layout, BlockOwner owner, Document& document,
                   TextureLibrary& textures);

} // namespace patina
