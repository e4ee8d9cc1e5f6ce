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

/// Holds an environment's picture as the renderer takes it, in two sizes.
struct EnvironmentImage {
    EnvironmentTexels whole; ///< is at most 4096 wide
    EnvironmentTexels small; ///< holds means over equal parts of `whole`, at most 512 wide, for
                             ///< sampling by brightness
    bool isMissing = false;  ///< is true for a placeholder, see missing()

    /// Makes one from a panorama of any size. NaN and negative numbers become black; larger numbers
    /// than a half float holds become its largest one. A panorama without pixels gives one black
    /// texel. A large one takes a while, so it should not run on a window's thread.
    static std::shared_ptr<const EnvironmentImage> from(const Image& panorama);

    /// Returns a placeholder for a picture that cannot be read: a checker that nobody takes for a
    /// real place, about as bright as one.
    static std::shared_ptr<const EnvironmentImage> missing();

    friend bool operator==(const EnvironmentImage&, const EnvironmentImage&) = default;
};

} // namespace patina
