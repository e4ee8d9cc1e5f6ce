// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/fresnel_block.h"

#include <fmt/format.h>

#include "shading/program/compiled_block.h"

namespace patina {
namespace {

/// Returns the value of the parameter with a role; null where there is none.
const Value* valueWithRole(const ValuedBlock& of, std::string_view role) {
    const Parameter* parameter = of.block->withRole(role);
    if (parameter == nullptr) {
        return nullptr;
    }
    const auto found = of.values.find(parameter->id);
    return found == of.values.end() ? &parameter->defaultValue : &found->second;
}

} // namespace

std::optional<double> ValuedBlock::number(std::string_view role) const {
    const Value* value = valueWithRole(*this, role);
    const double* number = value == nullptr ? nullptr : std::get_if<double>(value);
    return number == nullptr ? std::nullopt : std::optional(*number);
}

std::optional<glm::dvec3> ValuedBlock::vector(std::string_view role) const {
    const Value* value = valueWithRole(*this, role);
    const glm::dvec3* vector = value == nullptr ? nullptr : std::get_if<glm::dvec3>(value);
    return vector == nullptr ? std::nullopt : std::optional(*vector);
}

Result<ValuedBlock> fresnelBlock(const Catalog& catalog, const Material& material) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    const BlockValues* part = material.part(kinds::fresnel);
    const Slot* slot = model == nullptr ? nullptr : model->slot(kinds::fresnel);
    const std::string id = part != nullptr   ? part->id
                           : slot != nullptr ? slot->defaultBlock
                                             : std::string();
    if (id.empty()) {
        return failure("the material has no Fresnel term");
    }
    const Block* block = catalog.find(kinds::fresnel, id);
    if (block == nullptr) {
        return failure(fmt::format("there is no fresnel block \"{}\"", id));
    }
    return ValuedBlock{block, part != nullptr ? part->parameters : Values()};
}

std::optional<glm::dvec3> workedOutIndices(const ValuedBlock& fresnel) {
    const auto code = compiledBlock(*fresnel.block);
    const reference::BlockCall* call =
        code ? (*code)->optionalCall(reference::indicesSuffix) : nullptr;
    if (call == nullptr) {
        return std::nullopt;
    }
    glm::dvec3 indices(0.0);
    call->call(nullptr, &indices.x, packed(*fresnel.block, fresnel.values, {}));
    return indices;
}

} // namespace patina
