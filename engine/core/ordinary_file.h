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

/// No mesh and no image is read that is larger.
inline constexpr std::uintmax_t maxAssetBytes = std::uintmax_t(1) << 30;

/// An ordinary file that is open for reading. Everything that Patina reads is opened here: neither
/// a folder nor a pipe, a socket or a device, behind whatever links, is ever waited for, and what
/// is larger than its limit is not read at all.
class OrdinaryFile {
  public:
    /// Errors name the file and say what it is, or by how much it is too large.
    static Result<OrdinaryFile> open(const std::filesystem::path& file, std::uintmax_t maxBytes);

    /// Decides on a file by the full path of where it lies, all links followed.
    using Decision = std::function<bool(const std::filesystem::path& place)>;

    /// Opens a path from an open folder and what lies below it: a path that leads out of the
    /// folder, be it by "..", as a full path or through a link, is an error
    /// unless `mayLeave` says of what is there that it may.
    static Result<OrdinaryFile> openBelow(int folder, const std::filesystem::path& path,
                                          std::uintmax_t maxBytes, const Decision& mayLeave = {});

    OrdinaryFile(OrdinaryFile&& other) noexcept
        : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)),
          size_(other.size_), maxBytes_(other.maxBytes_) {}
    OrdinaryFile& operator=(OrdinaryFile&&) = delete;
    ~OrdinaryFile();

    int descriptor() const { return descriptor_; }

    /// Its size when it was opened, in bytes.
    std::uintmax_t size() const { return size_; }

    /// Gives the descriptor away; this file is empty afterwards.
    int release() { return std::exchange(descriptor_, -1); }

    /// Everything in it. What grows beyond the limit meanwhile, or never ends, is an error.
    Result<std::string> content() const;

    /// As many of its first bytes as there are.
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

/// Returns the content of an ordinary file of at most so many bytes.
Result<std::string> readFile(const std::filesystem::path& file, std::uintmax_t maxBytes);

} // namespace patina
