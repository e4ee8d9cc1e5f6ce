// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "catalog/descriptor.h"
#include "support/program.h"

namespace patina::tests {

/// Returns the smallest valid descriptor, with one parameter.
inline nlohmann::json plainDescriptor(const std::string& id) {
    return {{"id", id},
            {"version", 1},
            {"label", "Label of " + id},
            {"parameters",
             {{{"id", "gloss"}, {"label", "Gloss"}, {"type", "float"}, {"default", 0.5}}}}};
}

/// Makes a folder of blocks that tests fill.
class BlockFolder {
  public:
    BlockFolder() { std::filesystem::create_directories(root()); }

    std::filesystem::path root() const { return folder_ / "shaders"; }
    std::filesystem::path file(const std::string& kind, const std::string& id) const {
        return root() / kind / (id + ".json");
    }

    void addText(const std::string& kind, const std::string& id, const std::string& descriptor) {
        writeFile(file(kind, id), descriptor);
        writeFile(root() / kind / (id + ".glsl"), "");
    }
    void add(const std::string& kind, const nlohmann::json& descriptor) {
        addText(kind, descriptor["id"], descriptor.dump(1));
    }

    Catalog load() const { return loadCatalog(std::vector<BlockRoot>{{root(), true}}); }

  private:
    TemporaryFolder folder_;
};

} // namespace patina::tests
