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

/// Holds what a frame takes because of one effect: that of the frame with it, less that of the
/// frame without it, of pairs of frames that follow each other.
struct EffectCost {
    std::string effect; ///< EffectLine::effect
    MedianInterval milliseconds;
    int pairs = 0; ///< of frames

    /// Its interval holds 0: nobody can tell it from nothing.
    bool belowNoise() const { return milliseconds.contains(0.0); }

    /// There are pairs enough for an interval of 95 %.
    bool isSure() const { return pairs >= minForInterval; }

    friend bool operator==(const EffectCost&, const EffectCost&) = default;
};

/// The costs of a scene's effects as they were measured.
struct EffectCosts {
    MedianInterval frame; ///< milliseconds of the whole frame
    double rest = 0.0; ///< what no row accounts for: the frame less all rows that are within none
    std::vector<EffectCost> effects;
    glm::ivec2 size{0}; ///< pixels of the frames
    int pairs = 0;      ///< of frames, for each effect or more
    /// Seconds that pairs enough for every effect would have taken; 0: there are enough.
    double secondsNeeded = 0.0;
    std::string method; ///< how they were timed, for people
    Errors problems;    ///< what could not be drawn

    /// Null where the effect was not measured.
    const EffectCost* of(std::string_view effect) const;

    friend bool operator==(const EffectCosts&, const EffectCosts&) = default;
};

/// Measures what each effect costs by leaving it out: A B A B, with it and without it, at a fixed
/// size, effect after effect and round after round, so that whatever else the machine does meets
/// all of them alike. Made, used and destroyed with one context current.
class EffectCostMeter {
  public:
    struct Options {
        glm::ivec2 size{0}; ///< pixels; 0: 256 x 256 where the CPU draws, else 1024 x 1024
        int rounds = 15;    ///< pairs of frames for each effect
        std::filesystem::path programCache{}; ///< folder for program binaries; empty: none
        /// No pair is begun that would end later, but for the first; what programs take to be made
        /// does not count.
        double seconds = 20.0;
        bool mayShrink = false; ///< frames too slow for 7 rounds in that time are drawn smaller
    };

    /// Holds what is measured. The catalogue and the meshes must stay while it is.
    struct Subject {
        Scene scene;
        Camera camera;
        MeshSource meshes;
        std::vector<EffectRow> rows; ///< the removable ones are measured
        std::shared_ptr<const Catalog> catalog;
        TextureSource textures{}; ///< of the materials' images; empty: none are shown
        std::shared_ptr<const EnvironmentImage> environment{}; ///< see View::environmentImage
    };

    static Result<std::unique_ptr<EffectCostMeter>> create(Subject subject, const Options& options);
    ~EffectCostMeter();

    /// Draws one pair of frames, or one of the first frames, which only warm up.
    void step();
    bool finished() const;
    double progress() const; ///< 0 .. 1

    /// Holds what was measured so far.
    EffectCosts costs() const;

  private:
    class Implementation;
    explicit EffectCostMeter(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

/// The rows' costs added up as they are shown: of those that are not within another, and without
/// those below noise.
double sumOf(const EffectCosts& costs, const std::vector<EffectRow>& rows);

} // namespace patina
