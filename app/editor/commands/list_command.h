// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "commands/change_command.h"

namespace patina {

/// Adds (before: none), removes (after: none) or replaces the element at an index of a list.
template <class Element>
class ListCommand : public ChangeCommand<int, std::optional<Element>> {
  protected:
    ListCommand(Document& document, DocumentCommand::Kind kind, const QString& label, int index,
                std::optional<Element> before, std::optional<Element> after)
        : ChangeCommand<int, std::optional<Element>>(document, kind, label, index, before, after),
          isReplacement_(before.has_value() && after.has_value()) {}

    virtual std::vector<Element>& list() const = 0;
    virtual void announce() const = 0;

  private:
    void apply(const std::optional<Element>& wanted) override {
        const auto place = list().begin() + this->target();
        if (!wanted) {
            list().erase(place);
        } else if (isReplacement_) {
            *place = *wanted;
        } else {
            list().insert(place, *wanted);
        }
        announce();
    }

    bool isReplacement_;
};

} // namespace patina
