// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "reference/reference.h"

namespace patina::physics {

inline const Catalog& catalog() {
    static const Catalog loaded = [] {
        const std::vector<BlockRoot> roots{
            {std::filesystem::path(PATINA_SOURCE_DIR) / "shaders", true}};
        return loadCatalog(roots);
    }();
    return loaded;
}

/// Reads a published or independently computed table of tests/physics/data.
inline nlohmann::json table(const std::string& name) {
    std::ifstream stream(std::filesystem::path(PATINA_SOURCE_DIR) / "tests/physics/data" / name);
    return nlohmann::json::parse(stream);
}

inline glm::dvec3 direction(double degreesFromNormal, double azimuthDegrees) {
    const double theta = degreesFromNormal * std::numbers::pi / 180.0;
    const double phi = azimuthDegrees * std::numbers::pi / 180.0;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline reference::Geometry geometry(const glm::dvec3& l, const glm::dvec3& v) {
    return reference::geometry({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, l, v);
}

/// Is a block of the catalogue, its compiled code and a set of values for it.
struct Subject {
    const Block* block;
    const reference::Block* code;
    std::vector<double> parameters;

    Subject(const std::string& kind, const std::string& id, const Values& values = {},
            const AccuracyLevels& levels = {})
        : block(catalog().find(kind, id)), code(reference::findBlock(kind, id)) {
        if (block == nullptr || code == nullptr) {
            throw std::runtime_error("no block " + kind + "/" + id);
        }
        parameters = packed(*block, values, levels);
    }

    glm::dvec3 shade(const reference::Geometry& geometry,
                     const reference::Filler& slot = {}) const {
        return reference::shade(*code, geometry, parameters, {&slot, 1});
    }
    reference::Filler filler() const { return {code, parameters}; }
    double reflectance(double c) const { return code->fresnel(c, 1.0 - c, parameters).x; }
};

/// Makes a filler for a model's slot that reflects f0 at normal incidence, rising by Schlick's
/// power.
inline Subject schlickFrom(double f0) {
    return Subject("fresnel", "schlick", {{"f0", glm::dvec3(f0)}});
}

/// Returns the results of a function of the shader library.
inline std::vector<double> call(const std::string& name, const std::vector<double>& arguments) {
    const reference::Function* function = reference::findFunction(name);
    if (function == nullptr || function->arguments != arguments.size()) {
        throw std::runtime_error("no function " + name + " of so many arguments");
    }
    std::vector<double> results(function->results);
    function->call(arguments.data(), results.data());
    return results;
}

inline constexpr glm::dvec3 black{0.0, 0.0, 0.0};
inline constexpr glm::dvec3 white{1.0, 1.0, 1.0};

} // namespace patina::physics
