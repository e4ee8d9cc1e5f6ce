// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/written_block.h"

#include <array>
#include <system_error>

#include <stdlib.h>

#include "catalog/json_text.h"
#include "core/atomic_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Makes a folder that is removed when nobody knows it any more; null where none could be made.
std::shared_ptr<const fs::path> scratchFolder() {
    std::error_code none;
    std::string name = (fs::temp_directory_path(none) / "patina-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        return nullptr;
    }
    return {new fs::path(name), [](const fs::path* folder) {
                std::error_code ignored;
                fs::remove_all(*folder, ignored);
                delete folder;
            }};
}

} // namespace

Result<void> writeApproximatedBlock(const ApproximatedBlock& block,
                                    const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        return tl::unexpected(
            Error{folder.string(), 0, 0, "cannot be made: " + failed.message(), {}});
    }
    if (auto done = writeFileAtomically(folder / (block.id + ".glsl"), block.glsl); !done) {
        return done;
    }
    return writeFileAtomically(folder / (block.id + ".json"), writeJson(block.descriptor));
}

Checked<WrittenBlock> writtenBlock(const EvalCase& subject, const CheaperWays& ways,
                                   const fs::path& shaders) {
    auto folder = scratchFolder();
    if (!folder) {
        return tl::unexpected(oneError(Error{{}, 0, 0, "no folder for files could be made", {}}));
    }
    const auto made = approximatedBlock(subject, ways, usualNaming(*subject.block.block));
    if (!made) {
        return tl::unexpected(oneError(made.error()));
    }
    const std::string& kind = subject.block.block->kind;
    if (const auto done = writeApproximatedBlock(*made, *folder / kind); !done) {
        return tl::unexpected(oneError(done.error()));
    }
    const std::array roots{BlockRoot{shaders, true}, BlockRoot{*folder, false}};
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(roots));
    const Block* block = catalog->find(kind, made->id);
    if (block == nullptr) {
        return tl::unexpected(catalog->errors);
    }
    return WrittenBlock{std::move(folder), catalog, block, made->choice};
}

} // namespace patina
