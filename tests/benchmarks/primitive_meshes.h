// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "render/renderer.h"
#include "scene/primitives.h"

namespace patina::benchmarks {

/// Holds the built-in meshes that objects name ("builtin:<name>"), each made when it is asked for.
class PrimitiveMeshes {
  public:
    /// Returns a function that needs this object.
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
