// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include <QString>

#include "material/material.h"

namespace patina {

/// Describes a file at one moment, so that a change makes it differ.
struct FileStamp {
    std::filesystem::path file;
    std::int64_t bytes = -1;  ///< is -1 if the file does not exist
    std::int64_t written = 0; ///< nanoseconds since 1970

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

FileStamp stampOf(const std::filesystem::path& file);

/// Holds what was read from a preset file.
struct PresetEntry {
    std::filesystem::path file;
    QString path;                 ///< is `file` as text
    std::filesystem::path folder; ///< is the library's folder that holds it, directly or below
    bool shipped = true;
    Material material;
    QString name;       ///< is the material's name, or the file's without one
    QString modelLabel; ///< is the label of its lighting model, or the id if that is unknown
    QString searched;   ///< is all text that a search looks through, case folded
    std::vector<FileStamp> sources; ///< are the file itself, then the presets that it derives from
    /// Tells that it was written within 2 s before it was read: a later change may keep its stamps.
    bool isFresh = false;
};

using PresetPtr = std::shared_ptr<const PresetEntry>;

} // namespace patina
