// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "document/document_state.h"

namespace patina {

/// Keeps the scenes that the sides show where they are not the document's own. They are made on
/// demand.
class ShownScenes {
  public:
    /// Returns the scene as a side shows it, with the side's material on this object; valid until
    /// the state changes.
    const Scene& scene(const DocumentState& state, int object, Side side);

    /// A value of the state has changed. It is changed in place: copying a scene for a slider's
    /// tick would cost more than drawing it.
    void follow(const DocumentState& state, int object, const BlockPath& path,
                std::string_view parameterId);

    /// Something else has changed.
    void forget() { shown_ = {}; }

  private:
    /// Forgets scenes whose sides' materials are on another object.
    void keepFor(int object);
    void update(Side side, const DocumentState& state, int object, const BlockPath& path,
                std::string_view parameterId);

    std::array<std::optional<Scene>, sides.size()> shown_; ///< by side
    int object_ = -1;                                      ///< on which the sides' materials are
};

} // namespace patina
