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

/// Returns the states whose programs a change of this value may soon call for: one of each kind
/// whose programs differ from this state's, and this state itself where its programs leave
/// something out because of its place, which a drag may bring in.
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

    /// Takes over a value of the document that has changed, unless it is the dragged one.
    void follow(const DocumentState& state, const BlockPath& path, std::string_view parameterId);

    void end() { held_.reset(); }

    /// Tells whether the document by itself calls for other programs than the held ones.
    bool differs(const DocumentState& state, const Catalog& catalog) const;

    /// Returns the scene whose effects a side's programs have; null while nothing is held.
    const Scene* scene(Side side) const;

  private:
    struct Held {
        DocumentState state;
        /// Holds what the sides show, by side; absent where that is the state's scene.
        std::array<std::optional<Scene>, patina::sides.size()> shown;
        int object = -1;
        BlockPath path;
        std::string parameterId;
    };

    void showSides();

    std::optional<Held> held_;
};

} // namespace patina
