// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "catalog/catalog.h"
#include "predict/family_compiler.h"
#include "render/view.h"
#include "scene/scene.h"

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

/// Is the text of an object's shader, with the material that says how often its loops run.
struct PredictedSurface {
    ProgramText text;
    Material material;
};

/// Returns the text of the subject's object in each of these scenes.
Checked<std::vector<PredictedSurface>> surfaceTexts(const PredictedSubject& subject,
                                                    const std::vector<Scene>& scenes);

/// Compiles shaders, in their order. Where the compiler guesses how often loops of a model run that
/// vary with the directions, cycles and latency are those of their rounds on the mean
/// (varyingLoops()): of the shader with two rounds, and what a third takes for each of the others.
Result<CompiledForFamilies> compiledSurfaces(const std::vector<PredictedSurface>& surfaces,
                                             const Catalog& catalog,
                                             std::span<const GpuFamily* const> families,
                                             const FamilyCompilerOptions& options);

/// Compiles the subject's object in each of these scenes.
Checked<CompiledForFamilies> compiledScenes(const PredictedSubject& subject,
                                            const std::vector<Scene>& scenes,
                                            std::span<const GpuFamily* const> families,
                                            const FamilyCompilerOptions& options);

} // namespace patina
