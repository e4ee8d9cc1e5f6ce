// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include "document/document.h"
#include "text/short_text.h"

namespace patina {

/// One undoable edit of a document.
class DocumentCommand : public QUndoCommand {
  public:
    /// Kinds of edit that may merge with their own kind during one interaction.
    enum class Kind {
        Parameter = 1,
        Material,
        Compare,
        Light,
        SceneBlock,
        Object,
        Texture,
        Camera
    };

    int id() const override { return interaction_ == 0 ? -1 : static_cast<int>(kind_); }

  protected:
    DocumentCommand(Document& document, Kind kind, const QString& label)
        : QUndoCommand(shortened(label)), document_(document), kind_(kind),
          interaction_(document.interaction_) {}

    Document& document() const { return document_; }
    DocumentState& state() const { return document_.state_; }
    /// Side B is on the current object: an edit of it that is done again makes its own current.
    void showSecondOn(int object) const { document_.setCurrentObject(object); }
    bool isSameInteraction(const DocumentCommand& other) const {
        return interaction_ == other.interaction_;
    }

  private:
    Document& document_;
    Kind kind_;
    int interaction_; ///< 0: an edit of its own
};

} // namespace patina
