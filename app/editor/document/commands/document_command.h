// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include "document/document.h"
#include "text/short_text.h"

namespace patina {

/// Does one undoable edit of a document.
class DocumentCommand : public QUndoCommand {
  public:
    /// Returns the same id for all commands of one interaction, which the undo stack merges; -1
    /// outside one.
    int id() const override { return interaction_ == 0 ? -1 : interaction_; }

    /// Tells whether another command changes the same thing, so that the two may merge.
    virtual bool isOfSameTarget(const DocumentCommand& /*other*/) const { return false; }

    /// Returns the material that the edit brought to a place as a whole. Where it brought none,
    /// returns null and sets `place` to where that material was before the edit.
    virtual const Material* origin(MaterialPlace& /*place*/) const { return nullptr; }

  protected:
    DocumentCommand(Document& document, const QString& label)
        : QUndoCommand(shortened(label)), document_(document),
          interaction_(document.interaction().token()) {}

    Document& document() const { return document_; }
    DocumentState& state() const { return document_.state_; }
    /// Makes the object on which an edit of side B, C or D was made current, as these sides are
    /// shown on the current object only.
    void showSidesOn(int object) const { document_.setCurrentObject(object); }

  private:
    Document& document_;
    int interaction_; ///< is 0 for an edit of its own
};

} // namespace patina
