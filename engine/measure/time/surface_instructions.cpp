// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/surface_instructions.h"

#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/block_gate.h"
#include "shading/program/program_source.h"

namespace patina {

std::optional<InstructionCount> surfaceInstructions(const Scene& scene, std::size_t object,
                                                    const Camera& camera,
                                                    const TimedFrames::Supplies& supplies) {
    const EffectSet effects =
        effectSet(scene.objects[object].material, scene, *supplies.catalog,
                  effectView(scene, camera, *supplies.catalog, supplies.meshes));
    const auto source = surfaceProgram(effects, *supplies.catalog);
    if (!source || !gateAnswer(*source).mistakes.empty()) {
        return std::nullopt;
    }
    const auto count = countInstructions(source->fragment.text);
    return count ? std::optional(*count) : std::nullopt;
}

} // namespace patina
