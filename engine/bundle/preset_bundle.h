// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "material/material.h"

namespace patina {

// A bundle is a zip file of presets with the images and measured files that they name, and a
// picture of each: <name>.patina.json, images/<name>, measured/<name>, pictures/<name>.png.

/// Is a preset to put into a bundle.
struct BundledPreset {
    std::string name;      ///< is that of its file, without the suffix
    Material material;     ///< is written whole, also when it is a variant
    std::string picture{}; ///< holds the bytes of a PNG file; empty for none
};

/// Says whether one preset or file could be written or unpacked.
struct BundleOutcome {
    std::string name;
    std::string problem; ///< says what failed; empty when nothing did

    friend bool operator==(const BundleOutcome&, const BundleOutcome&) = default;
};

/// Limits what is taken from a bundle, so that a small file cannot fill a disk.
struct BundleLimits {
    std::uint64_t files = 20000;
    std::uint64_t fileBytes = 256u << 20;
    std::uint64_t bytes = std::uint64_t(2) << 30; ///< limits all files together, unpacked
};

/// Writes presets into a bundle and returns an outcome for each; a preset whose files cannot be
/// read is left out, and where none is left nothing is written. The file is replaced whole or not
/// at all; then the error says that it cannot be written.
Result<std::vector<BundleOutcome>> exportBundle(const std::filesystem::path& file,
                                                const std::vector<BundledPreset>& presets);

/// Holds the result of an import: the new folder, and an outcome for each file that is no picture.
struct BundleImport {
    std::filesystem::path folder;
    std::vector<BundleOutcome> outcomes;
};

/// Unpacks the presets and their files of a bundle into a new folder below `folder`, named after
/// the bundle. Paths that lead out of the bundle, links and anything else are refused, each with an
/// outcome. Fails, and leaves no folder, when the bundle cannot be read or is larger than the
/// limits.
Result<BundleImport> importBundle(const std::filesystem::path& file,
                                  const std::filesystem::path& folder,
                                  const BundleLimits& limits = {});

} // namespace patina
