// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reference.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <glm/geometric.hpp>

namespace patina::reference {
namespace {

/// "ggx_d" -> "ggxD"; a name without underscores stays.
std::string camelCase(std::string_view name) {
    std::string result;
    bool capital = false;
    for (const char c : name) {
        if (c == '_') {
            capital = !result.empty();
        } else {
            result += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
            capital = false;
        }
    }
    return result;
}

bool sameLetters(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

/// Not std::max: that would turn a NaN into a zero and hide it.
double cut(double x) {
    return x < 0.0 ? 0.0 : x;
}

} // namespace

const Block* findBlock(std::string_view kind, std::string_view id) {
    const auto all = blocks();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Block& block) {
        return block.kind == kind && block.id == id;
    });
    return found == all.end() ? nullptr : &*found;
}

glm::dvec3 modelValue(const Block& model, const Geometry& geometry, Parameters parameters,
                      Fillers fillers) {
    const bool lit = !model.lightGate || glm::dot(geometry.n, geometry.l) > 0.0;
    const bool seen = !model.viewGate || glm::dot(geometry.n, geometry.v) > 0.0;
    return lit && seen ? model.model(geometry, parameters, fillers) : glm::dvec3(0.0);
}

glm::dvec3 shade(const Block& model, const Geometry& geometry, Parameters parameters,
                 Fillers fillers) {
    const glm::dvec3 value = modelValue(model, geometry, parameters, fillers);
    return {cut(value.x), cut(value.y), cut(value.z)};
}

// Where capitals do not follow the words ("pow_sc" is powSC) the letters alone decide.
const Function* findFunction(std::string_view name) {
    const auto all = functions();
    const std::string wanted = camelCase(name);
    auto found = std::find_if(all.begin(), all.end(),
                              [&](const Function& function) { return function.name == wanted; });
    if (found == all.end()) {
        found = std::find_if(all.begin(), all.end(), [&](const Function& function) {
            return sameLetters(function.name, wanted);
        });
    }
    return found == all.end() ? nullptr : &*found;
}

} // namespace patina::reference
