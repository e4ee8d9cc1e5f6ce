// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include "document/document.h"
#include "text/short_text.h"

namespace patina {

/// Does one undoable edit of a document.
class DocumentCommand : public QUndoCommand {
  public:
    /// The undo stack merges commands of one id: those of one interaction.
    int id() const override { return interaction_ == 0 ? -1 : interaction_; }

    /// Tells whether another command changes the same thing, so that the two may merge.
    virtual bool isOfSameTarget(const DocumentCommand& /*other*/) const { return false; }

    /// Goes back over the edit: returns the material that it brought to a place as a whole. Where
    /// it brought none, `place` is where that material was before.
    virtual const Material* origin(MaterialPlace& /*place*/) const { return nullptr; }

  protected:
    DocumentCommand(Document& document, const QString& label)
        : QUndoCommand(shortened(label)), document_(document),
          interaction_(document.interaction().token()) {}

    Document& document() const { return document_; }
    DocumentState& state() const { return document_.state_; }
    /// All sides but A are on the current object: an edit of them that is done again makes its own
    /// current.
    void showSidesOn(int object) const { document_.selection().setObject(object); }

  private:
    Document& document_;
    int interaction_; ///< 0: an edit of its own
};

} // namespace patina
