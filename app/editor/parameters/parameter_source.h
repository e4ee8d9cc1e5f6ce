// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/parameter.h"

namespace patina {

/// Where a form's values come from and where its edits go.
class ParameterSource {
  public:
    virtual ~ParameterSource() = default;

    virtual Value value(const Parameter& parameter) const = 0;
    virtual void setValue(std::string_view parameterId, const Value& value) = 0;

    /// Edits between these are one undo step, and drag this value; see Document.
    virtual int beginInteraction(std::string_view parameterId) = 0;
    virtual void endInteraction(int token) = 0;
};

} // namespace patina
