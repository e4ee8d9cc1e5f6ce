// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "catalog/catalog.h"
#include "render/lights/light_lists.h"
#include "scene/scene.h"
#include "shading/effects/light_set.h"

namespace patina {

/// Knows which kinds of lights reach the objects of a list: what no light of reaches them is not in
/// their programs. Lists in which lights but no kinds are missing have the same programs. Keeps its
/// memory from frame to frame.
class LightKinds {
  public:
    /// Begins a new frame. `effects` has the effects that the programs are to have.
    void begin(const Scene& effects, const Catalog& catalog);

    /// Returns the number of the kinds that are missing in a list, the same for lists in which the
    /// same are; 0: none.
    std::size_t missingKinds(const LightLists& lists, std::size_t list);

    /// Returns the lights of the kinds that are missing, as EffectView::unreached; null for 0.
    std::shared_ptr<const LightSet> lights(std::size_t missing) const;

  private:
    std::size_t find(const LightLists& lists, std::size_t list);

    std::vector<std::uint64_t> keys_;       ///< by kind: EffectKey::ofLight of its lights
    std::vector<std::size_t> kindOf_;       ///< by light: its kind + 1; 0: it is in no program
    std::vector<std::size_t> missingKinds_; ///< by list: missingKinds() + 1; 0: not known yet
    std::vector<char> isThere_;             ///< by kind
    LightSet found_;
    std::size_t missingCount_ = 0;
    std::vector<std::shared_ptr<LightSet>>
        lights_; ///< by missingKinds() - 1; those from missingCount_ on are spare
};

} // namespace patina
