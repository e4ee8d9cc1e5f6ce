// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include <QString>

#include "material/material.h"

namespace patina {

/// A file as it was at one moment.
struct FileStamp {
    std::filesystem::path file;
    std::int64_t bytes = -1;  ///< -1: it is not there
    std::int64_t written = 0; ///< nanoseconds

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

FileStamp stampOf(const std::filesystem::path& file);

/// A preset file that can be read.
struct PresetEntry {
    std::filesystem::path file;
    QString path;                 ///< the same
    std::filesystem::path folder; ///< the one of the library that it lies in or below
    bool shipped = true;
    Material material;
    QString name;                   ///< the material's, or the file's where that has none
    QString modelLabel;             ///< what its lighting model is called
    QString searched;               ///< all that a search looks through, case folded
    std::vector<FileStamp> sources; ///< what it was read from
    bool isFresh = false; ///< written so shortly before it was read that its stamps may deceive
};

using PresetPtr = std::shared_ptr<const PresetEntry>;

} // namespace patina
