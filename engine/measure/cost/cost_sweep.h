// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>

#include "measure/cost/cost_chart.h"
#include "measure/cost/sweep_step.h"

namespace patina {

/// Measures what each choice of a material costs and how wrong it is: the exact frame, every level
/// by itself, then the combinations that may be on the front. Works in steps; points are there as
/// soon as they are measured. Made, used and destroyed with one context current.
class CostSweep {
  public:
    /// Holds what is measured. The catalogue and the meshes must stay while it is.
    struct Subject {
        Scene scene; ///< its ground is left out: nothing of it can be computed more cheaply
        std::size_t object = 0;
        Camera camera;
        MeshSource meshes;
        std::shared_ptr<const Catalog> catalog;
        TextureSource textures{};
        std::shared_ptr<const EnvironmentImage> environment{};
    };

    struct Options {
        /// Pixels; 0: 1024 x 1024, 256 x 256 where the CPU draws, 64 x 64 where that draws pictures
        /// under an environment.
        glm::ivec2 size{0};
        Choice::Scope scope = Choice::Scope::Material;
        std::filesystem::path programCache{};
        CostPairs::Options pairs{};
        double seconds = 60.0;    ///< no combination is begun after that, and pairs get fewer
        bool combinations = true; ///< not only single choices
        ChosenLevels present{};   ///< what there is now is measured, too
        std::vector<std::string> only{}; ///< Choice::id of what is measured; empty: of all
    };

    static Result<std::unique_ptr<CostSweep>> create(Subject subject, const Options& options);
    ~CostSweep();

    /// Works for about so long, or for one frame where that takes longer: a frame that is timed is
    /// drawn at once, and a program is made at once.
    void step(std::chrono::milliseconds patience);
    bool finished() const;
    SweepStep doing() const;
    double progress() const; ///< 0 .. 1; falls back when combinations are found worth measuring

    /// Holds what was measured so far.
    const CostChart& chart() const;

    /// Says why it ended before its time; empty while all is well.
    const Errors& problems() const;

    /// Returns the frame that errors are measured against, of points with the exact one's
    /// directions of an environment; null before it is there.
    const LinearFrame* groundTruth() const;

    /// Returns where the levels go wrong: the relative error of each pixel, rows from the top.
    /// Draws a frame; empty before there is one to compare with.
    std::vector<double> errorMap(const ChosenLevels& levels);

  private:
    class Implementation;
    explicit CostSweep(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
