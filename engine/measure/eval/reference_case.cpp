// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/reference_case.h"

#include <algorithm>

#include "measure/eval/compiled_block.h"

namespace patina {
namespace {

using Subject = EvalCase::Subject;

ReferenceNumbers numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace

Result<ReferenceCode> ReferenceCode::find(const EvalCase& request) {
    const auto block = compiledBlock(*request.block.block);
    if (!block) {
        return tl::unexpected(block.error());
    }
    if (request.slot.block == nullptr) {
        return ReferenceCode{request.subject, *block, nullptr};
    }
    const auto slot = compiledBlock(*request.slot.block);
    if (!slot) {
        return tl::unexpected(slot.error());
    }
    return ReferenceCode{request.subject, *block, *slot};
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
    return numbers(reference::modelValue(*code_.block, geometry, values_, {&filler_, 1}));
}

ReferenceNumbers ReferenceCase::evaluate(const EvalPlace& place) const {
    switch (code_.subject) {
    case Subject::Model:
        return evaluate(geometryOf(place));
    case Subject::Fresnel: {
        const double c = std::clamp(place.number, 0.0, 1.0);
        return numbers(code_.block->fresnel(c, 1.0 - c, values_));
    }
    case Subject::Light: {
        const reference::Illumination light = code_.block->light(place.l, values_);
        return {light.l.x,        light.l.y,        light.l.z,
                light.radiance.x, light.radiance.y, light.radiance.z};
    }
    case Subject::Fields: {
        ReferenceNumbers results{};
        code_.block->findCall("").call(place.fields.data(), results.data(), values_);
        return results;
    }
    default:
        return {code_.block->fog({place.l, place.v, place.number}, values_)};
    }
}

} // namespace patina
