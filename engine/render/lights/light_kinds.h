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

/// Knows which kinds of lights reach the objects of a list of LightLists. The code of a kind that
/// does not reach them is left out of their programs. Lists with different lights of the same kinds
/// share their programs. It keeps its memory from frame to frame.
class LightKinds {
  public:
    /// Begins a frame. `effects` is the scene whose effects the programs have.
    void begin(const Scene& effects, const Catalog& catalog);

    /// Returns a number for the set of kinds that are missing in a list; lists with equal sets have
    /// equal numbers, and 0 means that none is missing.
    std::size_t missingKinds(const LightLists& lists, std::size_t list);

    /// Returns the lights of the missing kinds, for EffectView::unreached; null for 0.
    std::shared_ptr<const LightSet> lights(std::size_t missing) const;

  private:
    std::size_t find(const LightLists& lists, std::size_t list);

    std::vector<std::uint64_t> keys_;       ///< has for each kind EffectKey::ofLight of its lights
    std::vector<std::size_t> kindOf_;       ///< has for each light its kind + 1; 0 for one that is
                                            ///< in no program
    std::vector<std::size_t> missingKinds_; ///< has for each list missingKinds() + 1; 0 while that
                                            ///< is unknown
    std::vector<char> isThere_;             ///< says for each kind whether the list has a light of
                                            ///< it
    LightSet found_;
    std::size_t missingCount_ = 0;
    std::vector<std::shared_ptr<LightSet>> lights_; ///< has the lights for each missingKinds() - 1;
                                                    ///< those from missingCount_ on are unused
};

} // namespace patina
