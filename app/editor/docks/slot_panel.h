// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "document/document_state.h"

namespace patina {

class BlockChooser;
class Document;

/// Chooses what fills a slot of the active material's model, and edits its values. Hidden where the
/// model has no such slot; what was chosen is then kept in the material.
class SlotPanel : public QGroupBox {
    Q_OBJECT

  public:
    SlotPanel(Document& document, BlockPath::Part part, const QString& title,
              QWidget* parent = nullptr);

  private:
    void update();

    Document& document_;
    BlockPath::Part part_;
    BlockChooser* chooser_;
};

} // namespace patina
