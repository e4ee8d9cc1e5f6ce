// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "document/comparison.h"
#include "document/document_files.h"
#include "parameters/parameter_form.h"
#include "support/program.h"

namespace patina::tests {

/// Is a folder of blocks written for the tests: two models that share some parameters, one Fresnel
/// block, two lights and a fog. The editor must not treat any of their names specially.
class FixtureBlocks {
  public:
    FixtureBlocks();

    const std::shared_ptr<const Catalog>& catalog() const { return catalog_; }
    std::filesystem::path folder() const { return folder_.path(); }
    /// Writes a descriptor and its shader, and reads all blocks again.
    void add(const std::string& kind, const std::string& id, const std::string& descriptor,
             const std::string& glsl);

  private:
    void write(const std::string& kind, const std::string& id, const std::string& descriptor,
               const std::string& glsl) const;
    void load();

    TemporaryFolder folder_;
    std::shared_ptr<const Catalog> catalog_;
};

/// Makes a scene with one object that has the first model, and one light.
Scene fixtureScene(const Catalog& catalog);

/// Holds a document of that scene.
struct FixtureDocument {
    FixtureBlocks blocks;
    Document document{blocks.catalog()};
    DocumentFiles files{document};
    Comparison comparison{document};

    FixtureDocument() { files.startFrom(fixtureScene(*blocks.catalog())); }

    BlockPath model() const { return document.selection().currentPath(kinds::models); }
    Value value(const std::string& id) const;
    double number(const std::string& id) const { return std::get<double>(value(id)); }
    int steps() { return document.undoStack().count(); }
};

} // namespace patina::tests
