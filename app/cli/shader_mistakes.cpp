// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shader_mistakes.h"

#include <algorithm>
#include <system_error>

#include "catalog/block_kind.h"
#include "measure/time/instruction_count.h"
#include "shading/effects/block_trial.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code missing;
    return fs::equivalent(a, b, missing) && !missing;
}

/// Returns the roots of all blocks that one of this root may be used with. A root that has a
/// library of its own is a whole one.
std::vector<BlockRoot> rootsWith(const fs::path& root) {
    std::error_code absent;
    if (fs::is_directory(root / "lib", absent)) {
        return {{root, true}};
    }
    std::vector<BlockRoot> roots = standardBlockRoots();
    roots.push_back({root, false});
    return roots;
}

} // namespace

Errors ShaderMistakes::of(const fs::path& descriptor) {
    const fs::path file = fs::absolute(descriptor).lexically_normal();
    if (findKind(file.parent_path().filename().string()) == nullptr) {
        return {};
    }
    const Catalog& catalog = catalogWith(file.parent_path().parent_path());
    const auto block = std::ranges::find_if(
        catalog.blocks, [&](const Block& each) { return isSame(each.descriptorFile, file); });
    if (block != catalog.blocks.end()) {
        const auto program = trialProgram(*block, catalog);
        return program ? compilerMistakes(*program) : program.error();
    }
    Errors mistakes; // as of a file that is missing
    for (const Error& error : catalog.errors) {
        if (isSame(fs::path(error.file).replace_extension(".json"), file)) {
            mistakes.push_back(error);
        }
    }
    return mistakes;
}

const Catalog& ShaderMistakes::catalogWith(const fs::path& root) {
    const bool isKnown = std::ranges::any_of(
        catalog_.roots, [&](const BlockRoot& each) { return isSame(each.folder, root); });
    if (isKnown) {
        return catalog_;
    }
    const auto known = others_.find(root);
    return known != others_.end()
               ? known->second
               : others_.emplace(root, loadCatalog(rootsWith(root))).first->second;
}

} // namespace patina
