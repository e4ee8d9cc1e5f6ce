// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "document/commands/change_command.h"

namespace patina {

/// Adds (before: none), removes (after: none) or replaces the element at an index of a list. What
/// comes in is the current one then; what was current before stays or becomes so again.
template <class Element>
class ListCommand : public ChangeCommand<int, std::optional<Element>> {
  protected:
    ListCommand(Document& document, const QString& label, int index, std::optional<Element> before,
                std::optional<Element> after, int current)
        : ChangeCommand<int, std::optional<Element>>(document, label, index, before, after),
          isReplacement_(before.has_value() && after.has_value()), isAddition_(!before),
          current_(current) {}

    bool isAddition() const { return isAddition_; }
    bool isReplacement() const { return isReplacement_; }

    virtual std::vector<Element>& list() const = 0;
    virtual void announce() const = 0;
    virtual void setCurrent(int index) const = 0;

  private:
    void apply(const std::optional<Element>& wanted) override {
        const auto place = list().begin() + this->target();
        if (!wanted) {
            list().erase(place);
            announce();
            setCurrent(!isAddition_ && current_ > this->target() ? current_ - 1 : current_);
            return;
        }
        if (isReplacement_) {
            *place = *wanted;
        } else {
            list().insert(place, *wanted);
        }
        announce();
        if (!isReplacement_) {
            setCurrent(isAddition_ ? this->target() : current_);
        }
    }

    bool isReplacement_;
    bool isAddition_;
    int current_; ///< is the current index before the edit
};

} // namespace patina
