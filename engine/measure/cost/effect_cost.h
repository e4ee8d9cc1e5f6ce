// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "measure/time/median_interval.h"
#include "render/renderer.h"
#include "shading/effects/effect_rows.h"

namespace patina {

/// Holds the time of one effect: that of a frame with it less that of a frame without it, from
/// pairs of consecutive frames.
struct EffectCost {
    std::string effect; ///< is an EffectLine::effect
    MedianInterval milliseconds;
    int pairs = 0; ///< counts pairs of frames

    /// Tells whether the interval contains 0, so that the effect cannot be told from nothing.
    bool belowNoise() const { return milliseconds.contains(0.0); }

    /// Tells whether there are pairs enough for an interval of 95 %.
    bool isSure() const { return pairs >= minForInterval; }

    friend bool operator==(const EffectCost&, const EffectCost&) = default;
};

/// Holds the time of one pass of a frame, of frames in which each pass is waited for.
struct PassCost {
    std::string pass;            ///< is what it draws, in words
    MedianInterval milliseconds; ///< is that of a frame in which something has moved
    int frames = 0;              ///< counts those that were timed

    friend bool operator==(const PassCost&, const PassCost&) = default;
};

/// Holds the measured costs of a scene's effects.
struct EffectCosts {
    MedianInterval frame; ///< milliseconds of the frame with all effects
    double rest = 0.0;    ///< milliseconds of the frame less all rows that are within no other
    std::vector<EffectCost> effects;
    glm::ivec2 size{0}; ///< pixels of the frames
    int pairs = 0;      ///< counts pairs of frames that each effect has at least
    /// Is how many seconds enough pairs for every effect would take; 0 where there are enough.
    double secondsNeeded = 0.0;
    std::string method;             ///< says how they were timed, for users
    Errors problems;                ///< say what could not be drawn
    std::vector<PassCost> passes{}; ///< are in the order in which they are drawn

    /// Returns the cost of an effect; null where it was not measured.
    const EffectCost* of(std::string_view effect) const;

    /// Returns the milliseconds of all passes, waited for one by one.
    double ofAllPasses() const;

    /// Returns the passes that take a thousandth of that or more: the others are only waited for.
    std::vector<PassCost> visiblePasses() const;

    friend bool operator==(const EffectCosts&, const EffectCosts&) = default;
};

/// Measures the cost of each effect by leaving it out: A B A B, with it and without it, at a fixed
/// size, effect after effect and round after round, so that other load of the machine affects all
/// of them alike. It must be made, used and destroyed with the same context current.
class EffectCostMeter {
  public:
    struct Options {
        glm::ivec2 size{0}; ///< pixels; 0: 256 x 256 where the CPU draws, else 1024 x 1024
        int rounds = 15;    ///< counts pairs of frames for each effect
        std::filesystem::path programCache{}; ///< is the folder of program binaries; empty: none
        /// Limits the time: no pair but the first is begun that would end later. Making programs
        /// does not count.
        double seconds = 20.0;
        bool mayShrink = false; ///< lets frames shrink that are too slow for 7 rounds in that time
    };

    /// Says what is measured. The meshes and images must stay valid meanwhile.
    struct Subject {
        Scene scene;
        Camera camera;
        MeshSource meshes;
        std::vector<EffectRow> rows; ///< are measured where they are removable
        std::shared_ptr<const Catalog> catalog;
        TextureSource textures{}; ///< gives the materials' images; empty: none are shown
        std::shared_ptr<const EnvironmentImage> environment{}; ///< is a View::environmentImage
    };

    static Result<std::unique_ptr<EffectCostMeter>> create(Subject subject, const Options& options);
    ~EffectCostMeter();

    /// Draws one pair of frames, or, at first, frames that only warm up.
    void step();
    bool finished() const;
    double progress() const; ///< 0 .. 1

    /// Returns what was measured so far.
    EffectCosts costs() const;

  private:
    class Implementation;
    explicit EffectCostMeter(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

/// Returns the sum of the rows' costs in milliseconds, of those that are within no other and not
/// below the noise.
double sumOf(const EffectCosts& costs, const std::vector<EffectRow>& rows);

} // namespace patina
