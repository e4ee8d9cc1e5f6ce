// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/surface_output.h"

#include <algorithm>

namespace patina {

AlbedoTableShape albedoTableShape(const Block& model) {
    const bool isotropic =
        std::find(model.claims.begin(), model.claims.end(), "isotropic") != model.claims.end();
    return isotropic ? AlbedoTableShape{{24, 1}, 24} : AlbedoTableShape{};
}

} // namespace patina
