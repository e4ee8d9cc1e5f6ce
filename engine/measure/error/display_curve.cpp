// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/display_curve.h"

#include <glm/common.hpp>

#include "catalog/parameter_layout.h"
#include "core/color.h"
#include "core/exposure.h"
#include "shading/program/compiled_block.h"

namespace patina {

DisplayCurve DisplayCurve::of(const Scene& scene, const Catalog& catalog) {
    DisplayCurve curve{scene.exposure};
    const BlockValues* part = scene.part(kinds::tone);
    const Block* block = part == nullptr ? nullptr : catalog.find(kinds::tone, part->id);
    if (block == nullptr) {
        return curve;
    }
    if (const auto code = compiledBlock(*block)) {
        curve.tone = *code;
        curve.values = packed(*block, part->parameters, {});
    }
    return curve;
}

glm::dvec3 DisplayCurve::shown(const glm::dvec3& light) const {
    const glm::dvec3 exposed = glm::min(light * exposureFactor(exposure), glm::dvec3(1e30));
    return srgbEncoded(tone == nullptr ? exposed : tone->toned(exposed, values));
}

} // namespace patina
