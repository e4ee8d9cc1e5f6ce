// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "core/image.h"

namespace patina {

/// Holds texels of an environment's picture as half floats, RGBA, rows from the top.
struct EnvironmentTexels {
    glm::ivec2 size{0};
    std::vector<std::uint16_t> halves;

    friend bool operator==(const EnvironmentTexels&, const EnvironmentTexels&) = default;
};

/// Represents an environment's picture as the renderer takes it.
struct EnvironmentImage {
    EnvironmentTexels whole; ///< at most 4096 wide
    EnvironmentTexels small; ///< means over equal parts of it, at most 512 wide: where it is bright
    bool isMissing = false;  ///< a placeholder, see missing()

    /// Makes one from a panorama of any size. NaN becomes black; what is beyond a half float's
    /// range becomes its largest number. Takes a while for a large one: not for a window's own
    /// thread.
    static std::shared_ptr<const EnvironmentImage> from(const Image& panorama);

    /// In place of a picture that cannot be read: a checker that nobody takes for a real place,
    /// about as bright as one.
    static std::shared_ptr<const EnvironmentImage> missing();

    friend bool operator==(const EnvironmentImage&, const EnvironmentImage&) = default;
};

} // namespace patina
