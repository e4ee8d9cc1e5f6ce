// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

/// Collects what a mesh file has and a mesh has not, to be told by name.
class LeftOut {
  public:
    enum class What {
        Animation,
        Skin,
        MorphTargets,
        Camera,
        Light,
        PointsAndLines,
        Extension,
        Image,        ///< is of a material, as are the next ones
        MissingImage, ///< is not in the folder of the mesh, or may not be read
        ShearedImage, ///< is turned and scaled in an order that ours are not
        ImageEdge,    ///< is a way to go on beyond it that differs along the two axes
        VertexColors,
        Anisotropy, ///< is stronger than a model has it
        MaterialExtension,
        MaterialExtras ///< are what another program keeps for itself
    };
    static constexpr std::size_t whats = 15;

    /// Adds one. A name may be empty, and is cut where it is long.
    void add(What what, std::string_view name);

    /// Returns "not read: 2 animations (Walk, Run), 1 skin"; empty where there is nothing. What
    /// materials have is told only if they are `wanted`.
    std::string text(bool areMaterialsWanted) const;

  private:
    struct Found {
        std::size_t count = 0;
        std::vector<std::string> names; ///< are the first ones, each once
    };

    std::array<Found, whats> found_;
};

} // namespace patina
