// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>

#include "scene/scene.h"

namespace patina {

/// Says how finely a side draws its picture while ways to draw it are compared: what is laid over
/// the values of the scene, which keeps its own.
struct SidePicture {
    PictureAccuracy accuracy;
    std::optional<BlockValues> transparency; ///< absent: the scene's own
    Values environment;                      ///< those that are not the scene's own
    std::map<std::size_t, Values> shadows;   ///< the same by light

    friend bool operator==(const SidePicture&, const SidePicture&) = default;
};

/// Two ways to draw the picture of one scene.
struct ComparedPicture {
    /// Is what side B was given: it shows the objects' own materials until its material is another.
    Material material;
    std::optional<SidePicture> first; ///< of side A; absent: the scene's own
    std::optional<SidePicture> second;

    friend bool operator==(const ComparedPicture&, const ComparedPicture&) = default;
};

/// Returns what is to be laid over a scene so that its picture is that of another one, which
/// differs in how finely it is drawn alone.
SidePicture pictureOf(const Scene& shown, const Scene& own);

/// Lays it over the scene. What it names and the scene has no more is passed over.
void layOver(Scene& scene, const SidePicture& picture);

} // namespace patina
