// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "document/document_state.h"

namespace patina {

/// Returns what changing a value may soon call other programs for: a state of each kind that
/// differs from this one in its programs, and this one where it lacks something because of its
/// place, which a drag brings in.
std::vector<DocumentState> prewarmed(const DocumentState& state, const BlockPath& path,
                                     const Parameter& parameter, const Catalog& catalog);

/// Keeps the effects of a dragged value in the programs. A light of intensity 0, an opacity of 1 or
/// a black ambient colour is left out of them; a slider that passes such a value would need another
/// program under the artist's hand. While it is dragged, the views take the programs of a document
/// where that one value has an effect, which are made when the drag begins.
class FrozenEffects {
  public:
    /// Holds the effects of the state in which the drag begins. `object` is the current one, on
    /// which side B's material is. Holds nothing when the value never decides about programs.
    void begin(const DocumentState& state, int object, const BlockPath& path,
               const Parameter& parameter, const Catalog& catalog);

    /// Keeps an image of a material in the programs too, whatever becomes of its strength.
    void keepTexture(const DocumentState& state, int object, const BlockPath& path,
                     const std::string& key);

    /// A value of the document has changed: all but the dragged one count.
    void follow(const DocumentState& state, const BlockPath& path, std::string_view parameterId);

    /// Stops holding.
    void end() { held_.reset(); }

    /// Tells whether the document by itself calls for other programs than the held ones.
    bool differs(const DocumentState& state, const Catalog& catalog) const;

    /// Returns the scene whose effects a side's programs have; null while nothing is held.
    const Scene* scene(Side side) const;

  private:
    struct Held {
        DocumentState state;
        /// Is what the sides show, where that is not the state's scene.
        std::array<std::optional<Scene>, patina::sides.size()> shown;
        int object = -1;
        BlockPath path;
        std::string parameterId;
    };

    void showSides();

    std::optional<Held> held_;
};

} // namespace patina
