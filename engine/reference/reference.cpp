// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reference.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <glm/geometric.hpp>

namespace patina::reference {
namespace {

/// Returns "ggxD" for "ggx_d"; a name without underscores is unchanged.
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

/// Returns 0 for a number below 0. std::max would turn a NaN into 0 and hide it.
double cut(double x) {
    return x < 0.0 ? 0.0 : x;
}

} // namespace

namespace {

glm::dvec3 triple(const std::array<double, 3>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

std::array<double, 8> numbersOf(const Interface& x) {
    return {x.l.x, x.l.y, x.l.z, x.n.x, x.n.y, x.n.z, double(x.channel), double(x.leaves)};
}

} // namespace

const BlockCall& Block::findCall(std::string_view suffix) const {
    return *std::find_if(calls.begin(), calls.end(),
                         [suffix](const BlockCall& call) { return call.suffix == suffix; });
}

const BlockCall* Block::optionalCall(std::string_view suffix) const {
    const auto found = std::ranges::find(calls, suffix, &BlockCall::suffix);
    return found == calls.end() ? nullptr : &*found;
}

const ModelFactor* Block::findFactor(std::string_view suffix) const {
    const auto found = std::find_if(factors.begin(), factors.end(),
                                    [suffix](const ModelFactor& f) { return f.suffix == suffix; });
    return found == factors.end() ? nullptr : &*found;
}

glm::dvec3 Block::fresnel(double c, double versine, Parameters parameters) const {
    return triple(call<3>("", std::array{c, versine}, parameters));
}

glm::dvec3 Block::tint(Parameters parameters) const {
    return triple(call<3>("Tint", {}, parameters));
}

Illumination Block::light(const glm::dvec3& x, Parameters parameters) const {
    const auto lit = call<6>("", std::array{x.x, x.y, x.z}, parameters);
    return {{lit[0], lit[1], lit[2]}, {lit[3], lit[4], lit[5]}};
}

double Block::fog(const FogRay& ray, Parameters parameters) const {
    const std::array numbers{ray.eye.x,       ray.eye.y,       ray.eye.z, ray.direction.x,
                             ray.direction.y, ray.direction.z, ray.range};
    return call<1>("", numbers, parameters)[0];
}

glm::dvec3 Block::fogColor(Parameters parameters) const {
    return triple(call<3>("Color", {}, parameters));
}

glm::dvec3 Block::environment(const glm::dvec3& d, const glm::dvec3& picture,
                              Parameters parameters) const {
    const std::array numbers{d.x, d.y, d.z, picture.x, picture.y, picture.z};
    return triple(call<3>("", numbers, parameters));
}

glm::dvec3 Block::toned(const glm::dvec3& light, Parameters parameters) const {
    return triple(call<3>("", std::array{light.r, light.g, light.b}, parameters));
}

double Block::transparency(double depth, double opacity, Parameters parameters) const {
    return call<1>("", std::array{depth, opacity}, parameters)[0];
}

glm::dvec3 Block::refract(const Interface& at, Parameters parameters) const {
    return triple(call<3>("", numbersOf(at), parameters));
}

double Block::mirrored(const Interface& at, Parameters parameters) const {
    return call<1>("Mirrored", numbersOf(at), parameters)[0];
}

glm::dvec3 Block::left(double way, Parameters parameters) const {
    return triple(call<3>("Left", std::array{way}, parameters));
}

glm::dvec2 Block::outline(const Edge& edge, Parameters parameters) const {
    const std::array numbers{double(edge.silhouette), double(edge.open), edge.dihedral};
    const auto widths = call<2>("", numbers, parameters);
    return {widths[0], widths[1]};
}

glm::dvec3 Block::lineColor(Parameters parameters) const {
    return triple(call<3>("Color", {}, parameters));
}

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

// Some capitals do not begin words ("pow_sc" is powSC): then the letters alone decide.
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
