// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "scene/scene.h"

namespace patina {

/// Holds the picture settings of one side while such settings are compared. They overlay the
/// values of the scene, which keeps its own.
struct SidePicture {
    PictureAccuracy accuracy;
    std::optional<BlockValues> transparency; ///< is absent where the scene's own applies
    Values environment;                      ///< holds only values that differ from the scene's
    std::map<std::size_t, Values> shadows;   ///< holds the same by index of the light
    std::map<std::size_t, Values> passes;    ///< holds the same by index of the pass

    friend bool operator==(const SidePicture&, const SidePicture&) = default;
};

/// Holds the settings of two pictures of one scene that are compared.
struct ComparedPicture {
    /// Holds what side B was given: it shows the objects' own materials until its material is
    /// another.
    Material material;
    std::optional<SidePicture> first; ///< is side A's; absent where the scene's own applies
    std::optional<SidePicture> second;

    friend bool operator==(const ComparedPicture&, const ComparedPicture&) = default;
};

/// Returns what has to overlay `own` to get the picture of `shown`. The two scenes may differ
/// in their picture settings only.
SidePicture pictureOf(const Scene& shown, const Scene& own);

/// Lays picture settings over a scene. Those of parts, lights and passes that the scene does not
/// have are skipped.
void layOver(Scene& scene, const SidePicture& picture);

} // namespace patina
