// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "catalog/catalog.h"
#include "render/light_lists.h"
#include "scene/scene.h"

namespace patina {

/// Which kinds of lights reach the objects of a list: what no light of reaches them is not in their
/// programs. Lists that lack lights and no kind have the same programs. Keeps its memory from frame
/// to frame.
class LightKinds {
  public:
    /// A new frame. `effects` has the effects that the programs are to have.
    void begin(const Scene& effects, const Catalog& catalog);

    /// The lights of the kinds that the list lacks, as EffectView::unreached has them.
    std::uint64_t unreached(const LightLists& lists, std::size_t list) const;

  private:
    /// Lights that one loop of a program goes through.
    struct Kind {
        std::uint64_t key = 0;    ///< EffectKey::ofLight
        std::uint64_t lights = 0; ///< as EffectView::unreached
        bool isKnown = true;      ///< all of its lights are among these
    };

    std::vector<Kind> kinds_;
};

} // namespace patina
