// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/model_values.h"

#include <glm/common.hpp>

#include "core/vectors.h"
#include "measure/eval/eval_source.h"

namespace patina {

Result<ModelValues> ModelValues::of(const EvalCase& model, const Catalog& catalog) {
    ModelValues values;
    if (const auto code = ReferenceCode::find(model)) {
        values.code_ = *code;
    } else {
        const auto text = InterpretedModel::of(model, catalog.roots.front().folder);
        if (!text) {
            return tl::unexpected(text.error());
        }
        values.interpreted_ = *text;
    }
    return values.with(model);
}

ModelValues ModelValues::with(const EvalCase& model) const {
    ModelValues values = *this;
    if (code_) {
        values.compiled_ = std::make_shared<const ReferenceCase>(
            *code_, model.block.packedValues(),
            model.slot.block != nullptr ? model.slot.packedValues() : std::vector<double>());
    } else {
        values.numbers_ = valueNumbers(model);
        values.isEndless_ = std::make_shared<std::atomic<bool>>(false);
    }
    return values;
}

glm::dvec3 ModelValues::at(const DirectionPair& pair) const {
    glm::dvec3 value(0.0);
    if (compiled_ != nullptr) {
        reference::Geometry geometry;
        geometry.l = pair.l;
        geometry.v = pair.v;
        const ReferenceNumbers numbers = compiled_->evaluate(geometry);
        value = {numbers[0], numbers[1], numbers[2]};
    } else if (!isEndless()) { // one that does not end takes long enough
        EvalCase place;
        place.l = pair.l;
        place.v = pair.v;
        std::vector<double> numbers = placeNumbers(place);
        numbers.insert(numbers.end(), numbers_.begin(), numbers_.end());
        const std::optional<glm::dvec3> found = interpreted_->evaluate(numbers);
        if (!found) {
            *isEndless_ = true;
        }
        value = found.value_or(value);
    }
    return isFinite(value) ? glm::max(value, glm::dvec3(0.0)) : glm::dvec3(0.0);
}

} // namespace patina
