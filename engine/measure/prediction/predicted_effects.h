// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/prediction/predicted_subject.h"
#include "shading/effects/effect_rows.h"

namespace patina {

/// Holds what the object's shader is without one effect.
struct PredictedEffect {
    std::string effect; ///< is an EffectLine::effect
    Result<FamilyStatistics> without;
};

struct PredictedEffects {
    std::string driver;
    Result<FamilyStatistics> whole; ///< is the shader with all effects
    std::vector<PredictedEffect> effects;

    /// Returns how many cycles for 64 pixels less the shader takes on a family without an effect;
    /// nothing where that was not compiled.
    std::optional<double> cyclesOf(std::string_view effect, const std::string& family) const;
    std::optional<int> instructionsOf(std::string_view effect, const std::string& family) const;

    /// Returns why the shader without an effect was not compiled; null where it was, and for what
    /// cannot be left out.
    const Error* problemOf(std::string_view effect) const;
};

/// Predicts what leaving out each effect that can be left out saves in the object's shader. Nothing
/// is drawn.
Checked<PredictedEffects> predictedEffects(const PredictedSubject& subject,
                                           std::span<const EffectRow> rows,
                                           std::span<const GpuFamily* const> families,
                                           const FamilyCompilerOptions& options = {});

} // namespace patina
