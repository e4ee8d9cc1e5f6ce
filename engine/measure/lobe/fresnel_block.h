// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

#include "material/material.h"
#include "reference/reference.h"

namespace patina {

/// Is a block with the values that are read by the roles of its parameters.
struct ValuedBlock {
    const Block* block = nullptr;
    Values values;

    /// Return the value of the parameter with a role; nothing where there is none of that type.
    std::optional<double> number(std::string_view role) const;
    std::optional<glm::dvec3> vector(std::string_view role) const;
};

/// Returns the Fresnel block that fills the slot of a material's model or is blended over its
/// light. It is an error where there is none.
Result<ValuedBlock> fresnelBlock(const Catalog& catalog, const Material& material);

/// Returns the index of each channel that a Fresnel block works out from its values, by the
/// function with reference::indicesSuffix; nothing where it has none.
std::optional<glm::dvec3> workedOutIndices(const ValuedBlock& fresnel);

} // namespace patina
