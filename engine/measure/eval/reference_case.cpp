// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/reference_case.h"

#include <algorithm>

#include "shading/program/compiled_block.h"

namespace patina {
namespace {

using Subject = EvalCase::Subject;

ReferenceNumbers threeNumbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// Returns the numbers that a function takes at a place.
FieldNumbers argumentsOf(Subject subject, const EvalPlace& place) {
    switch (subject) {
    case Subject::Fresnel: {
        const double c = std::clamp(place.number, 0.0, 1.0);
        return {c, 1.0 - c};
    }
    case Subject::Light:
        return {place.l.x, place.l.y, place.l.z};
    case Subject::Fog:
        return {place.l.x, place.l.y, place.l.z, place.v.x, place.v.y, place.v.z, place.number};
    default:
        return place.fields;
    }
}

} // namespace

Result<ReferenceCode> ReferenceCode::find(const EvalCase& request) {
    const auto block = compiledBlock(*request.block.block);
    if (!block) {
        return tl::unexpected(block.error());
    }
    ReferenceCode code{request.subject, *block, nullptr, nullptr};
    if (request.subject != Subject::Model) {
        code.call = &(*block)->findCall(calledFunction(request).suffix);
    }
    if (request.slot.block == nullptr) {
        return code;
    }
    const auto slot = compiledBlock(*request.slot.block);
    if (!slot) {
        return tl::unexpected(slot.error());
    }
    code.slot = *slot;
    return code;
}

reference::Geometry geometryOf(const EvalPlace& place) {
    reference::Geometry geometry = reference::geometry(place.n, place.t, place.l, place.v);
    geometry.pixel = place.pixel;
    return geometry;
}

ReferenceCase::ReferenceCase(const ReferenceCode& code, std::vector<double> values,
                             std::vector<double> slotValues)
    : code_(code), values_(std::move(values)), slotValues_(std::move(slotValues)) {
    if (code_.slot != nullptr) {
        filler_ = {code_.slot, slotValues_};
    }
}

ReferenceNumbers ReferenceCase::evaluate(const reference::Geometry& geometry) const {
    return threeNumbers(reference::modelValue(*code_.block, geometry, values_, {&filler_, 1}));
}

ReferenceNumbers ReferenceCase::evaluate(const EvalPlace& place) const {
    if (code_.subject == Subject::Model) {
        return evaluate(geometryOf(place));
    }
    ReferenceNumbers results{};
    code_.call->call(argumentsOf(code_.subject, place).data(), results.data(), values_);
    return results;
}

} // namespace patina
