// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <stdexcept>

#include "measure/lobe/lobe_model.h"
#include "physics_cases.h"

namespace patina::physics {

/// Is a material of a model with other values than the defaults.
inline Material materialOf(const std::string& model, const Values& values = {}) {
    Material material = defaultMaterial(*catalog().find(kinds::models, model));
    for (const auto& [id, value] : values) {
        material.model.parameters[id] = value;
    }
    return material;
}

inline LobeModel modelOf(const Material& material, LobeTerm term = LobeTerm::Whole) {
    auto model = LobeModel::create(catalog(), material, term);
    if (!model) {
        throw std::runtime_error(model.error().text());
    }
    return std::move(*model);
}

inline double worst(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

} // namespace patina::physics
