// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/surface_output.h"

#include <algorithm>

namespace patina {

namespace {

bool isIsotropic(const Block& model) {
    return std::ranges::find(model.claims, "isotropic") != model.claims.end();
}

} // namespace

AlbedoTableShape albedoTableShape(const Block& model) {
    return isIsotropic(model) ? AlbedoTableShape{{24, 1}, 24} : AlbedoTableShape{};
}

LobeTableShape lobeTableShape(const Block& model) {
    return isIsotropic(model) ? LobeTableShape{64, 1, 8} : LobeTableShape{};
}

} // namespace patina
