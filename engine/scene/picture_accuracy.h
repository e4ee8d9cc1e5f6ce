// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace patina {

/// Tells what a picture may compute less exactly, whatever its materials (see
/// picture_choice_text.h).
enum class PictureChoice : std::uint8_t {
    Samples,
    Lighting,
    Normals,
    Highlights,
    Fog,
    Scale,
    Numbers,
    Environment
};

inline constexpr std::size_t pictureChoices = 8;

/// Holds the level of each choice, of which 0 is the exact one. A new one has the defaults, of
/// which Samples and Numbers are not exact.
class PictureAccuracy {
  public:
    std::size_t level(PictureChoice choice) const {
        return levels_[static_cast<std::size_t>(choice)];
    }

    /// Sets a choice's level; one beyond the last becomes the last.
    void choose(PictureChoice choice, std::size_t level);

    /// Returns how many samples of a pixel are taken for edges: 8, 4, 2 or 1.
    int samples() const { return 8 >> level(PictureChoice::Samples); }

    bool lightsAtVertices() const { return level(PictureChoice::Lighting) > 0; }
    bool leavesNormals() const { return level(PictureChoice::Normals) > 0; }
    bool widensHighlights() const { return level(PictureChoice::Highlights) > 0; }
    /// Tells whether an environment's light is computed from fitted lobes instead of averaged over
    /// directions.
    bool fitsEnvironment() const { return level(PictureChoice::Environment) > 0; }

    bool fogsAtVertices() const { return level(PictureChoice::Fog) > 0; }

    /// Returns how many pixels are drawn for one of the picture along each side: 1, 0.75 or 0.5.
    double scale() const { return 1.0 - 0.25 * static_cast<double>(level(PictureChoice::Scale)); }

    /// Tells whether light is summed in 32 bits a channel instead of 16.
    bool hasWholeNumbers() const { return level(PictureChoice::Numbers) == 0; }

    friend bool operator==(const PictureAccuracy&, const PictureAccuracy&) = default;

  private:
    std::array<std::uint8_t, pictureChoices> levels_{1, 0, 0, 0, 0, 0, 1, 0};
};

} // namespace patina
