// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "core/error.h"

namespace patina {

/// Limits the size of the meshes and images that are read, in bytes.
inline constexpr std::uintmax_t maxAssetBytes = std::uintmax_t(1) << 30;

/// Is an ordinary file that is open for reading. Everything that Patina reads is opened here: it
/// never waits for a folder, a pipe, a socket or a device, also behind links, and does not read a
/// file that is larger than its limit.
class OrdinaryFile {
  public:
    /// Opens a file for reading. Errors name the file and say what it is, or which limit it
    /// exceeds.
    static Result<OrdinaryFile> open(const std::filesystem::path& file, std::uintmax_t maxBytes);

    /// Decides whether a file may be read, by the full path of where it lies, all links followed.
    using Decision = std::function<bool(const std::filesystem::path& place)>;

    /// Opens a path relative to an open folder. A path that leads out of the folder, be it by "..",
    /// as a full path or through a link, is an error unless `mayLeave` allows what it leads to.
    static Result<OrdinaryFile> openBelow(int folder, const std::filesystem::path& path,
                                          std::uintmax_t maxBytes, const Decision& mayLeave = {});

    OrdinaryFile(OrdinaryFile&& other) noexcept
        : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)),
          size_(other.size_), maxBytes_(other.maxBytes_) {}
    OrdinaryFile& operator=(OrdinaryFile&&) = delete;
    ~OrdinaryFile();

    int descriptor() const { return descriptor_; }

    /// Returns the size in bytes when the file was opened.
    std::uintmax_t size() const { return size_; }

    /// Gives the descriptor away; this file is empty afterwards.
    int release() { return std::exchange(descriptor_, -1); }

    /// Returns the whole content. A file that grows beyond the limit meanwhile, or never ends, is
    /// an error.
    Result<std::string> content() const;

    /// Returns the first `bytes` bytes, or fewer where the file ends before.
    Result<std::string> start(std::size_t bytes) const;

  private:
    OrdinaryFile(std::filesystem::path file, int descriptor, std::uintmax_t maxBytes)
        : file_(std::move(file)), descriptor_(descriptor), maxBytes_(maxBytes) {}

    static Result<OrdinaryFile> checked(OrdinaryFile file);
    Error tooLarge() const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::uintmax_t size_ = 0;
    std::uintmax_t maxBytes_ = 0;
};

/// Returns the content of an ordinary file of at most `maxBytes` bytes.
Result<std::string> readFile(const std::filesystem::path& file, std::uintmax_t maxBytes);

} // namespace patina
