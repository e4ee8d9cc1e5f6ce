// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "measure/choice/choices.h"
#include "predict/family_compiler.h"
#include "render/view.h"
#include "shading/effects/effect_rows.h"

namespace patina {

/// Says whose shader's cost is predicted: that of one object, as its scene calls for it.
struct PredictedSubject {
    Scene scene;
    std::size_t object = 0;
    MeshSource meshes; ///< must stay valid meanwhile
    std::shared_ptr<const Catalog> catalog;
};

/// Returns the program that draws the object as the scene's camera sees it; the errors say why
/// there is none.
Checked<ProgramText> surfaceText(const PredictedSubject& subject);

/// Holds what one way to compute a material is on each family.
struct PredictedWay {
    ChosenLevels levels; ///< are those that are not exact
    Result<FamilyStatistics> statistics;
};

/// Holds the ways of several subjects, in their order.
struct PredictedWays {
    std::string driver;
    std::vector<std::vector<PredictedWay>> subjects;
};

/// Predicts what each subject's material costs when it is exact, then with each level of each of
/// its choices by itself, then with the levels that it has, where these are others. Nothing is
/// drawn.
Checked<PredictedWays> predictedWays(std::span<const PredictedSubject> subjects,
                                     std::span<const GpuFamily* const> families,
                                     const FamilyCompilerOptions& options = {});

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
};

/// Predicts what leaving out each effect that can be left out saves in the object's shader. Nothing
/// is drawn.
Checked<PredictedEffects> predictedEffects(const PredictedSubject& subject,
                                           std::span<const EffectRow> rows,
                                           std::span<const GpuFamily* const> families,
                                           const FamilyCompilerOptions& options = {});

} // namespace patina
