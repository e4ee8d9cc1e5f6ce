// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "measure/prediction/predicted_subject.h"

namespace patina {

/// Holds what a model with its defaults is on each family.
struct PredictedModel {
    std::string model;
    std::string label;
    Result<FamilyStatistics> statistics;
};

struct PredictedModels {
    std::string driver;
    std::vector<PredictedModel> models;
};

/// Predicts what the object costs with each model of the catalogue, in its order. Nothing is drawn.
Checked<PredictedModels> predictedModels(const PredictedSubject& subject,
                                         std::span<const GpuFamily* const> families,
                                         const FamilyCompilerOptions& options = {});

} // namespace patina
