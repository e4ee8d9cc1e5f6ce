// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/cost/cost_sweep.h"
#include "measure/time/choice_cost.h"

namespace patina {

/// Holds what a model costs with its defaults.
struct ModelCost {
    std::string model;
    std::string label;
    ChoiceCost cost;                              ///< ratios are to the quickest model
    std::optional<InstructionCount> instructions; ///< of its program, where that can be counted
    /// Is the share of an even white sky's light that it keeps; below 0: it sends out more than
    /// arrives. Nothing without code in double precision. See whiteSkyAlbedo().
    std::optional<double> albedoLoss;
    RatioBound bound = RatioBound::None; ///< of the ratio

    friend bool operator==(const ModelCost&, const ModelCost&) = default;
};

/// Makes ratios to whatever model ratios to the first of these, which is the quickest, with
/// intervals that hold what is not known of either.
void countFromQuickest(std::vector<ModelCost>& costs);

/// Ranks all models of the catalogue on one scene: the object that a sweep would measure gets each
/// of them with its defaults, round after round. Works in steps. Made, used and destroyed with one
/// context current.
class ModelRanking {
  public:
    static Result<std::unique_ptr<ModelRanking>> create(CostSweep::Subject subject,
                                                        const CostSweep::Options& options);
    ~ModelRanking();

    /// Draws two frames, one of them of the first model.
    void step();
    bool finished() const;
    double progress() const; ///< 0 .. 1

    /// Says which model is measured now.
    struct Turn {
        std::string label;
        std::size_t number = 1; ///< from 1 on
        std::size_t of = 1;
    };
    Turn turn() const;

    /// The models that are measured so far, the fastest first.
    std::vector<ModelCost> costs() const;

    std::string timer() const;
    std::size_t pixels() const; ///< that are shaded
    const Errors& problems() const;

  private:
    class Implementation;
    explicit ModelRanking(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace patina
