// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "material/material.h"

namespace patina {

// A bundle is a zip file of presets with the images that they name, and a picture of each:
// <name>.patina.json, images/<name>, pictures/<name>.png.

/// A preset that is put into a bundle.
struct BundledPreset {
    std::string name;      ///< of its file, without the suffix
    Material material;     ///< whole: a variant is none in a bundle
    std::string picture{}; ///< a PNG file's bytes; empty: none
};

/// Says what became of one preset or file.
struct BundleOutcome {
    std::string name;
    std::string problem; ///< empty: it was done

    friend bool operator==(const BundleOutcome&, const BundleOutcome&) = default;
};

/// Says what is taken from a bundle at most, so that a small file cannot fill a disk.
struct BundleLimits {
    std::uint64_t files = 20000;
    std::uint64_t fileBytes = 256u << 20;
    std::uint64_t bytes = std::uint64_t(2) << 30; ///< of all files, unpacked
};

/// Writes presets into a bundle, an outcome for each; one whose images cannot be read is left out.
/// The file is replaced whole or not at all.
Result<std::vector<BundleOutcome>> exportBundle(const std::filesystem::path& file,
                                                const std::vector<BundledPreset>& presets);

/// Says what importing gave: the new folder, and what became of each file.
struct BundleImport {
    std::filesystem::path folder;
    std::vector<BundleOutcome> outcomes;
};

/// Unpacks the presets and images of a bundle into a new folder below `folder`, called as the
/// bundle. Paths that lead out of the bundle, links and anything else are refused, each with an
/// outcome. Nothing stays where the bundle cannot be read or is larger than the limits.
Result<BundleImport> importBundle(const std::filesystem::path& file,
                                  const std::filesystem::path& folder,
                                  const BundleLimits& limits = {});

} // namespace patina
