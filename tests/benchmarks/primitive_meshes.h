// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "render/renderer.h"
#include "scene/primitives.h"

namespace patina::benchmarks {

/// The built-in meshes that objects name ("builtin:<name>"), made when they are asked for.
class PrimitiveMeshes {
  public:
    /// This must stay.
    MeshSource source() {
        return [this](const Object& object) {
            const std::string name = object.mesh.substr(object.mesh.find(':') + 1);
            auto found = meshes_.find(name);
            if (found == meshes_.end()) {
                found = meshes_.emplace(name, primitive(name).value()).first;
            }
            return found->second.view();
        };
    }

  private:
    std::map<std::string, Mesh> meshes_;
};

} // namespace patina::benchmarks
