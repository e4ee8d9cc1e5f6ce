// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

/// Says which other files may be read when a preset or a scene is opened. Files in its folder, in
/// Patina's data and in the user's data folder of Patina need no consent; for others the user is
/// asked.
struct ReadingRights {
    std::filesystem::path
        folder{}; ///< replaces the file's own: the folder of the file it is a copy of
    std::set<std::string, std::less<>> allowed{}; ///< are full paths that the user agreed to
    bool everything = false; ///< says that the user agreed to whatever the file names
};

/// Names a file that a preset or a scene refers to and that is not read before the user agrees.
struct OutsideFile {
    enum class Kind {
        Mesh,
        Picture,
        Preset,
        Image,
        Link ///< is a file that a mesh names; it is known once the mesh was read
    };
    Kind kind = Kind::Image;
    std::string file; ///< is a full path with forward slashes

    friend auto operator<=>(const OutsideFile&, const OutsideFile&) = default;
};

using OutsideFiles = std::vector<OutsideFile>;

/// Returns the folder of a file, absolute: its relative references begin there, and what lies in it
/// needs no consent. Empty where `file` is empty.
std::filesystem::path referenceFolder(const std::filesystem::path& file);

/// Decides whether a file that another one names may be read, and remembers those that may not.
class References {
  public:
    /// Judges what this file names; `rights` must outlive it.
    References(const std::filesystem::path& file, const ReadingRights& rights);

    /// Returns where relative paths begin.
    const std::filesystem::path& base() const { return base_; }

    /// Tells whether a file may be read, by its path as it is written; if not, it is remembered.
    bool mayRead(std::string_view named, OutsideFile::Kind kind);

    /// Returns the rights of a preset that this file names and may read. A preset in the folder may
    /// read from there too; another one only beside itself.
    ReadingRights rightsOf(std::string_view preset) const;

    /// Adds what was not read for another file.
    void add(const OutsideFiles& others);

    /// Returns what was not read, each once.
    const OutsideFiles& outside() const { return outside_; }

  private:
    std::string fullPath(std::string_view named) const;
    bool isInside(std::string_view named) const;

    std::filesystem::path base_;
    const ReadingRights& rights_;
    OutsideFiles outside_;
};

} // namespace patina
