// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "catalog/descriptor.h"
#include "catalog/descriptor_checks.h"
#include "catalog/kind_checks.h"
#include "catalog/shader_names.h"
#include "catalog/suggestion.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Tells whether a folder is one of a kind; beside them are shared functions and entry points.
bool isKindFolder(const fs::path& folder) {
    const std::string name = folder.filename().string();
    return name != "lib" && name != "passes" && !name.empty() && name.front() != '.';
}

/// Returns what is in a folder, sorted by name; empty when it cannot be read.
std::vector<fs::path> entriesOf(const fs::path& folder, std::error_code& status) {
    std::vector<fs::path> entries;
    for (fs::directory_iterator at(folder, status), end; !status && at != end;
         at.increment(status)) {
        entries.push_back(at->path());
    }
    std::sort(entries.begin(), entries.end());
    return entries;
}

void append(Errors& errors, const Errors& more) {
    errors.insert(errors.end(), more.begin(), more.end());
}

/// Tells whether a file is one that editors leave beside another: a hidden one, a lock or a copy.
bool isNobodysFile(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.starts_with('.') || name.starts_with('#') || name.ends_with('~');
}

/// Tells whether the status is a mistake: the shipped folder must exist, the user's may be missing.
bool isMistake(const BlockRoot& root, std::error_code status) {
    return status && (root.shipped || status != std::errc::no_such_file_or_directory);
}

Error unreadable(const BlockRoot& root, std::error_code status) {
    const char* const what = root.shipped ? "the folder of the lighting models"
                                          : "the folder of your own lighting models";
    const char* const expected =
        root.shipped ? "the shaders that come with Patina" : "a folder that may be read";
    return {root.folder.string(), 0, 0,
            fmt::format("{} cannot be read: {}", what, status.message()), expected};
}

/// Reports missing folders. It is used when the schema of descriptors cannot be read, and so no
/// block.
Errors missingRoots(std::span<const BlockRoot> roots) {
    Errors errors;
    for (const BlockRoot& root : roots) {
        std::error_code status;
        entriesOf(root.folder, status);
        if (isMistake(root, status)) {
            errors.push_back(unreadable(root, status));
        }
    }
    return errors;
}

Errors kindMistakes() {
    Errors errors;
    for (const BlockKind& kind : blockKinds()) {
        if (std::string mistake = kindMistake(kind); !mistake.empty()) {
            errors.push_back({"", 0, 0, std::move(mistake), "Incidence, or a struct of fields"});
        }
    }
    return errors;
}

/// Reads all roots into one catalogue.
class Loader {
  public:
    explicit Loader(const JsonSchema& schema) : schema_(schema) {}

    Catalog run(std::span<const BlockRoot> roots) {
        catalog_.roots.assign(roots.begin(), roots.end());
        catalog_.errors = kindMistakes();
        for (const BlockRoot& root : roots) {
            readRoot(root);
        }
        checkSlots();
        for (Descriptor& descriptor : descriptors_) {
            catalog_.blocks.push_back(std::move(descriptor.block));
        }
        std::sort(catalog_.blocks.begin(), catalog_.blocks.end(),
                  [](const Block& a, const Block& b) {
                      return std::tie(a.kind, a.id) < std::tie(b.kind, b.id);
                  });
        return std::move(catalog_);
    }

  private:
    void readRoot(const BlockRoot& root) {
        std::error_code status;
        for (const fs::path& folder : entriesOf(root.folder, status)) {
            std::error_code ignored;
            if (isKindFolder(folder) && fs::is_directory(folder, ignored) && isKnownKind(folder)) {
                readKind(folder, root.shipped);
            }
        }
        if (isMistake(root, status)) {
            catalog_.errors.push_back(unreadable(root, status));
        }
    }

    /// Reports a folder of any other name, since it is a typing mistake that nothing else would
    /// report.
    bool isKnownKind(const fs::path& folder) {
        const std::string name = folder.filename().string();
        if (findKind(name) != nullptr) {
            return true;
        }
        std::vector<std::string> known;
        for (const BlockKind& kind : blockKinds()) {
            known.emplace_back(kind.folder);
        }
        catalog_.errors.push_back({folder.string(), 0, 0,
                                   fmt::format("\"{}\" is no kind of block", name),
                                   oneOf(name, known)});
        return false;
    }

    void readKind(const fs::path& folder, bool shipped) {
        std::error_code status;
        for (const fs::path& file : entriesOf(folder, status)) {
            if (isNobodysFile(file)) {
                continue;
            }
            if (file.extension() == ".json") {
                readBlock(file, shipped);
            } else if (file.extension() == ".glsl") {
                checkDescriptorExists(file);
            }
        }
        if (status) {
            catalog_.errors.push_back(
                {folder.string(), 0, 0, "the folder cannot be read: " + status.message(), {}});
        }
    }

    void checkDescriptorExists(const fs::path& shader) {
        const fs::path descriptor = fs::path(shader).replace_extension(".json");
        std::error_code status;
        if (!fs::exists(descriptor, status)) {
            catalog_.errors.push_back({shader.string(), 0, 0, "the shader has no descriptor",
                                       "a file " + descriptor.filename().string() + " beside it"});
        }
    }

    void readBlock(const fs::path& file, bool shipped) {
        Checked<Descriptor> descriptor = readDescriptor(file, schema_);
        if (!descriptor) {
            append(catalog_.errors, descriptor.error());
            return;
        }
        descriptor->block.shipped = shipped;
        if (isUnique(*descriptor) && leavesIds(*descriptor) &&
            (shipped || leavesNames(*descriptor))) {
            descriptors_.push_back(std::move(*descriptor));
        }
    }

    bool isUnique(const Descriptor& descriptor) {
        const std::string name = structName(descriptor.block);
        for (const Descriptor& other : descriptors_) {
            if (structName(other.block) == name) {
                catalog_.errors.push_back(descriptor.document.error(
                    "/id",
                    fmt::format("the {} block \"{}\" is already there", other.block.kind,
                                other.block.id),
                    "an id that " + other.block.descriptorFile.string() + " leaves free"));
                return false;
            }
        }
        return true;
    }

    /// Checks that no former id is the id of a block of that kind.
    bool leavesIds(const Descriptor& descriptor) {
        std::vector<std::string> taken = idsOfKind(descriptor.block.kind);
        taken.push_back(descriptor.block.id);
        for (const std::string& former : descriptor.block.formerIds) {
            if (std::ranges::find(taken, former) != taken.end()) {
                catalog_.errors.push_back(descriptor.document.error(
                    "/formerIds", fmt::format("\"{}\" is the id of a block", former),
                    "ids that no block of the kind has any more"));
                return false;
            }
        }
        return true;
    }

    /// Checks the names in a block's shader. Tests do so for the shipped blocks; only for others
    /// every shader is read.
    bool leavesNames(const Descriptor& descriptor) {
        if (takenNames_.empty() && !catalog_.roots.empty()) {
            takenNames_ = shaderNames(catalog_.roots.front().folder);
        }
        const Errors mistakes = nameMistakes(descriptor, takenNames_);
        append(catalog_.errors, mistakes);
        return mistakes.empty();
    }

    std::vector<std::string> idsOfKind(const std::string& kind) const {
        std::vector<std::string> ids;
        for (const Descriptor& descriptor : descriptors_) {
            if (descriptor.block.kind == kind) {
                ids.push_back(descriptor.block.id);
            }
        }
        return ids;
    }

    bool hasItsSlots(const Descriptor& descriptor) {
        const Errors mistakes =
            slotMistakes(descriptor, [this](const std::string& kind) { return idsOfKind(kind); });
        catalog_.errors.insert(catalog_.errors.end(), mistakes.begin(), mistakes.end());
        return mistakes.empty();
    }

    void checkSlots() {
        std::vector<Descriptor> complete;
        std::copy_if(descriptors_.begin(), descriptors_.end(), std::back_inserter(complete),
                     [this](const Descriptor& descriptor) { return hasItsSlots(descriptor); });
        descriptors_ = std::move(complete);
    }

    const JsonSchema& schema_;
    std::vector<Descriptor> descriptors_;
    ShaderNames takenNames_; ///< are used by the shaders of the first root
    Catalog catalog_;
};

} // namespace

const Block* Catalog::find(std::string_view kind, std::string_view id) const {
    const Block* renamed = nullptr;
    for (const Block& block : blocks) {
        if (block.kind == kind && block.id == id) {
            return &block;
        }
        if (block.kind == kind && std::ranges::find(block.formerIds, id) != block.formerIds.end()) {
            renamed = &block;
        }
    }
    return renamed;
}

std::vector<const Block*> Catalog::ofKind(std::string_view kind) const {
    std::vector<const Block*> found;
    for (const Block& block : blocks) {
        if (block.kind == kind) {
            found.push_back(&block);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Block* a, const Block* b) { return a->label < b->label; });
    return found;
}

Catalog loadCatalog(std::span<const BlockRoot> roots) {
    Catalog catalog;
    const Result<JsonSchema> schema = JsonSchema::load("descriptor");
    if (schema) {
        catalog = Loader(*schema).run(roots);
    } else {
        catalog.errors = missingRoots(roots);
        catalog.errors.push_back(schema.error());
    }
    catalog.roots.assign(roots.begin(), roots.end());
    return catalog;
}

} // namespace patina
