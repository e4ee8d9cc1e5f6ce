// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "catalog/catalog.h"
#include "measure/approximation/approximated_block.h"

namespace patina {

/// Writes the two files of a block into a folder, which is made where it is missing.
Result<void> writeApproximatedBlock(const ApproximatedBlock& block,
                                    const std::filesystem::path& folder);

/// Is a block with found ways that was written into a folder of its own, which goes with it, and
/// read again.
struct WrittenBlock {
    std::shared_ptr<const std::filesystem::path> folder; ///< removes it at the end
    std::shared_ptr<const Catalog> catalog;              ///< has the shipped blocks as well
    const Block* block = nullptr;
    std::string choice; ///< is the id of the accuracy choice whose levels the ways are
};

/// Writes a block with the ways and reads it again. The errors say why that is not possible, and
/// what is wrong with its text.
Checked<WrittenBlock> writtenBlock(const EvalCase& subject, const CheaperWays& ways,
                                   const std::filesystem::path& shaders);

} // namespace patina
