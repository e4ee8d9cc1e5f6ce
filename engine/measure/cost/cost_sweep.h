// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "measure/cost/cost_chart.h"
#include "measure/cost/sweep_step.h"

namespace patina {

/// Measures the time and the error of each choice of a material: the exact frame, every level by
/// itself, then the combinations that may be on the front. It works in steps, and chart() has each
/// point as soon as it is measured. It must be made, used and destroyed with the same context
/// current.
class CostSweep {
  public:
    /// Says what is measured. The meshes and images must stay valid meanwhile.
    struct Subject {
        Scene scene; ///< is measured without its ground, which has no choices
        std::size_t object = 0;
        Camera camera;
        MeshSource meshes;
        std::shared_ptr<const Catalog> catalog;
        TextureSource textures{};
        std::shared_ptr<const EnvironmentImage> environment{};
    };

    struct Options {
        /// Is in pixels. 0 means 1024 x 1024, 256 x 256 where the CPU draws, and 64 x 64 where that
        /// draws pictures under an environment.
        glm::ivec2 size{0};
        Choice::Scope scope = Choice::Scope::Material;
        std::filesystem::path programCache{};
        CostPairs::Options pairs{};
        double seconds = 60.0;           ///< limits the time: later no combination is begun
        bool combinations = true;        ///< asks for them, not only for single choices
        ChosenLevels present{};          ///< are measured in any case
        std::vector<std::string> only{}; ///< are the Choice::id of what is measured; empty: all
        /// Gives what a point costs in any unit, so that its time is not measured; a point without
        /// such a cost is left out. Empty: times are measured.
        std::function<std::optional<double>(const ChosenLevels&)> given{};
    };

    static Result<std::unique_ptr<CostSweep>> create(Subject subject, const Options& options);
    ~CostSweep();

    /// Works for about so long, or longer where one frame that is timed, or one program, takes
    /// longer.
    void step(std::chrono::milliseconds patience);
    bool finished() const;
    SweepStep doing() const;
    double progress() const; ///< 0 .. 1; falls when combinations turn out worth measuring

    /// Returns what was measured so far.
    const CostChart& chart() const;

    /// Returns why it ended early; empty while all is well.
    const Errors& problems() const;

    /// Returns the frame with which points are compared that have the exact one's directions of an
    /// environment; null before it is done.
    const LinearFrame* groundTruth() const;

    /// Draws the frame of these levels and returns the relative error of each pixel, rows from the
    /// top. Empty before there is a frame to compare with, or where drawing fails.
    std::vector<double> errorMap(const ChosenLevels& levels);

  private:
    class Implementation;
    explicit CostSweep(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
