// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "document/commands/document_command.h"

namespace patina {

/// Replaces one value by another. `Target` says which value of the document it is; edits of
/// different values whose `Held` is the same need targets of different types. Within one
/// interaction changes of one target merge; one that ends where it began is dropped.
template <class Target, class Held>
class ChangeCommand : public DocumentCommand {
  public:
    void redo() override { apply(after_); }
    void undo() override { apply(before_); }

    bool isOfSameTarget(const DocumentCommand& next) const override {
        const auto* other = dynamic_cast<const ChangeCommand*>(&next);
        return other && target_ == other->target_;
    }

    bool mergeWith(const QUndoCommand* next) override {
        const auto* other = dynamic_cast<const ChangeCommand*>(next);
        if (!other || !isOfSameTarget(*other)) {
            return false;
        }
        after_ = other->after_;
        setObsolete(after_ == before_);
        return true;
    }

  protected:
    ChangeCommand(Document& document, const QString& label, Target target, Held before, Held after)
        : DocumentCommand(document, label), target_(std::move(target)), before_(std::move(before)),
          after_(std::move(after)) {}

    const Target& target() const { return target_; }
    const Held& before() const { return before_; }
    const Held& after() const { return after_; }

    virtual void apply(const Held& value) = 0;

  private:
    Target target_;
    Held before_;
    Held after_;
};

} // namespace patina
