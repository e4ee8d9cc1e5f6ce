// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

/// Holds what opening a preset or a scene may read beside it. Files in its folder, in Patina's data
/// and in the user's own folder of Patina need no leave; for others the user is asked.
struct ReadingRights {
    std::filesystem::path
        folder{}; ///< counts in place of the file's own: that of which it is a copy
    std::set<std::string, std::less<>> allowed{}; ///< full paths that the user agreed to
    bool everything = false;                      ///< the user agreed to whatever the file names
};

/// Represents a file that a preset or a scene names and that is not read before its user agrees.
struct OutsideFile {
    enum class Kind {
        Mesh,
        Picture,
        Preset,
        Image,
        Link ///< named by a mesh: it is known when the mesh was read
    };
    Kind kind = Kind::Image;
    std::string file; ///< a full path with forward slashes

    friend auto operator<=>(const OutsideFile&, const OutsideFile&) = default;
};

using OutsideFiles = std::vector<OutsideFile>;

/// Returns the folder that a file's references count against: relative ones begin there, and what
/// lies in it needs no leave. Empty for what is no file.
std::filesystem::path referenceFolder(const std::filesystem::path& file);

/// Decides of each file that another one names whether it is read, and remembers those that are
/// not.
class References {
  public:
    /// Judges what this file names; `rights` outlive it.
    References(const std::filesystem::path& file, const ReadingRights& rights);

    /// Returns where relative paths begin.
    const std::filesystem::path& base() const { return base_; }

    /// Tells whether a file may be read, as it is named.
    bool mayRead(std::string_view named, OutsideFile::Kind kind);

    /// The rights of a preset that this file names and may read.
    ReadingRights rightsOf(std::string_view preset) const;

    /// Adds what another file's reading left out.
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
