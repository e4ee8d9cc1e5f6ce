// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/model_values.h"

#include <glm/common.hpp>

#include "core/vectors.h"

namespace patina {

Result<ModelValues> ModelValues::of(const EvalCase& model) {
    const auto code = ReferenceCode::find(model);
    if (!code) {
        return tl::unexpected(code.error());
    }
    return ModelValues(std::make_shared<const ReferenceCase>(
        *code, model.block.packedValues(),
        model.slot.block != nullptr ? model.slot.packedValues() : std::vector<double>()));
}

glm::dvec3 ModelValues::at(const DirectionPair& pair) const {
    reference::Geometry geometry;
    geometry.l = pair.l;
    geometry.v = pair.v;
    const ReferenceNumbers numbers = model_->evaluate(geometry);
    const glm::dvec3 value(numbers[0], numbers[1], numbers[2]);
    return isFinite(value) ? glm::max(value, glm::dvec3(0.0)) : glm::dvec3(0.0);
}

} // namespace patina
