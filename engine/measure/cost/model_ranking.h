// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/cost/cost_sweep.h"
#include "measure/time/choice_cost.h"
#include "predict/compile_request.h"

namespace patina {

/// Holds the cost of a model with its defaults, or with values that were given.
struct ModelCost {
    std::string model;
    std::string label;
    ChoiceCost cost; ///< has ratios to the quickest model
    std::optional<InstructionCount>
        instructions; ///< are those of its program; empty: not countable
    /// Is the share of a uniform white sky's light that is lost: 1 - whiteSkyAlbedo(). Below 0 it
    /// reflects more than arrives. Empty without code in double precision.
    std::optional<double> albedoLoss;
    RatioBound bound = RatioBound::None; ///< tells whether the ratio is a bound
    /// Is what its program is on graphics cards that are not here; empty where nobody asked.
    Result<FamilyStatistics> predicted{FamilyStatistics()};

    friend bool operator==(const ModelCost&, const ModelCost&) = default;
};

/// Turns ratios to any one model into ratios to the first of these, which must be the quickest. The
/// intervals contain the uncertainty of both.
void countFromQuickest(std::vector<ModelCost>& costs);

/// Ranks all models of the catalogue on one scene: the subject's object gets each of them with its
/// defaults, or each of the materials that are given, round after round. It works in steps, and
/// must be made, used and destroyed with the same context current.
class ModelRanking {
  public:
    /// `materials` replace the defaults of every model; a material whose model is not known is left
    /// out.
    static Result<std::unique_ptr<ModelRanking>> create(CostSweep::Subject subject,
                                                        const CostSweep::Options& options,
                                                        std::vector<Material> materials = {});
    ~ModelRanking();

    /// Draws a pair of frames, one of them with the first model.
    void step();
    bool finished() const;
    double progress() const; ///< 0 .. 1

    /// Says which model is measured now.
    struct Turn {
        std::string label;
        std::size_t number = 1; ///< counts from 1
        std::size_t of = 1;
    };
    Turn turn() const;

    /// Returns the models that are measured so far, the fastest first.
    std::vector<ModelCost> costs() const;

    std::string timer() const;
    std::size_t pixels() const; ///< counts those that are shaded
    /// Are those of models that were left out, or why nothing could be measured.
    const Errors& problems() const;

  private:
    class Implementation;
    explicit ModelRanking(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
