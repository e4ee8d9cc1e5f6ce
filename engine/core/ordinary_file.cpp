// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ordinary_file.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/paths.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Opens without waiting for the other end of a pipe, and without becoming the owner of a terminal.
constexpr int openFlags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;

constexpr const char* leadsOut = "lies outside the folder";

Error errorOf(const fs::path& file, std::string problem, std::string expected = {}) {
    return Error{file.string(), 0, 0, std::move(problem), std::move(expected)};
}

Error cannotOpen(const fs::path& file, int reason) {
    switch (reason) {
    case ENOENT:
    case ENOTDIR:
        return errorOf(file, "no such file");
    case EACCES:
    case EPERM:
        return errorOf(file, "cannot be read: permission denied");
    case ENXIO: // what the system says of a socket and of a device that is not there
        return errorOf(file, "is not an ordinary file", "a file");
    default:
        return errorOf(file, "cannot be read: " + std::generic_category().message(reason));
    }
}

/// Says what is wrong with anything but an ordinary file.
Error notOrdinary(const fs::path& file, mode_t mode) {
    const char* const what = S_ISDIR(mode)                    ? "is a folder"
                             : S_ISFIFO(mode)                 ? "is a pipe"
                             : S_ISSOCK(mode)                 ? "is a socket"
                             : S_ISCHR(mode) || S_ISBLK(mode) ? "is a device"
                                                              : "is not an ordinary file";
    return errorOf(file, what, "a file");
}

std::string sizeText(std::uintmax_t bytes) {
    constexpr std::uintmax_t kibi = 1u << 10;
    constexpr std::uintmax_t mebi = 1u << 20;
    constexpr std::uintmax_t gibi = 1u << 30;
    if (bytes >= gibi && bytes % gibi == 0) {
        return fmt::format("{} GiB", bytes / gibi);
    }
    if (bytes >= mebi && bytes % mebi == 0) {
        return fmt::format("{} MiB", bytes / mebi);
    }
    return bytes % kibi == 0 ? fmt::format("{} KiB", bytes / kibi) : fmt::format("{} bytes", bytes);
}

/// Owns a descriptor that stands for what a path leads to without opening it.
class Place {
  public:
    explicit Place(int descriptor) : descriptor_(descriptor) {}
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }

    int get() const { return descriptor_; }

  private:
    int descriptor_;
};

/// Returns the path under which the system knows an open descriptor.
fs::path openedAs(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

/// Returns the full path of what is open, all links followed; empty when the system does not say.
fs::path pathOf(int descriptor) {
    std::error_code failed;
    return fs::read_symlink(openedAs(descriptor), failed);
}

} // namespace

OrdinaryFile::~OrdinaryFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

Result<OrdinaryFile> OrdinaryFile::open(const fs::path& file, std::uintmax_t maxBytes) {
    // To open a device may already do something, so it is asked what it is before; afterwards once
    // more, since it may have become another one in between.
    struct stat facts {};
    if (::stat(file.c_str(), &facts) != 0) {
        return tl::unexpected(cannotOpen(file, errno));
    }
    if (!S_ISREG(facts.st_mode)) {
        return tl::unexpected(notOrdinary(file, facts.st_mode));
    }
    const int descriptor = ::open(file.c_str(), openFlags);
    if (descriptor < 0) {
        return tl::unexpected(cannotOpen(file, errno));
    }
    return checked(OrdinaryFile(file, descriptor, maxBytes));
}

Result<OrdinaryFile> OrdinaryFile::openBelow(int folder, const fs::path& path,
                                             std::uintmax_t maxBytes, const Decision& mayLeave) {
    const Place place(::openat(folder, path.c_str(), O_PATH | O_CLOEXEC));
    if (place.get() < 0) {
        return tl::unexpected(cannotOpen(path, errno));
    }
    // Both are held open: nobody can put something else there between this and the reading.
    const fs::path there = pathOf(place.get());
    const bool isOutside = !isWithin(there, pathOf(folder));
    if (isOutside && (there.empty() || !mayLeave || !mayLeave(there))) {
        return tl::unexpected(errorOf(path, leadsOut, "a file in the folder or below it"));
    }
    struct stat facts {};
    if (::fstat(place.get(), &facts) != 0 || !S_ISREG(facts.st_mode)) {
        return tl::unexpected(notOrdinary(path, facts.st_mode));
    }
    const int descriptor = ::open(openedAs(place.get()).c_str(), openFlags);
    if (descriptor < 0) {
        return tl::unexpected(cannotOpen(path, errno));
    }
    return checked(OrdinaryFile(path, descriptor, maxBytes));
}

Result<OrdinaryFile> OrdinaryFile::checked(OrdinaryFile file) {
    struct stat facts {};
    if (::fstat(file.descriptor_, &facts) != 0) {
        return tl::unexpected(cannotOpen(file.file_, errno));
    }
    if (!S_ISREG(facts.st_mode)) {
        return tl::unexpected(notOrdinary(file.file_, facts.st_mode));
    }
    file.size_ = static_cast<std::uintmax_t>(facts.st_size);
    if (file.size_ > file.maxBytes_) {
        return tl::unexpected(file.tooLarge());
    }
    return file;
}

Error OrdinaryFile::tooLarge() const {
    return errorOf(file_, "is larger than " + sizeText(maxBytes_));
}

Result<std::string> OrdinaryFile::content() const {
    auto all = start(static_cast<std::size_t>(maxBytes_) + 1);
    if (all && all->size() > maxBytes_) {
        return tl::unexpected(tooLarge());
    }
    return all;
}

/// Reads in growing pieces: the size is only a first guess, which is wrong for files that grow and
/// for those that the system makes up while they are read.
Result<std::string> OrdinaryFile::start(std::size_t bytes) const {
    constexpr std::size_t minRoom = 4096;
    std::string text;
    std::size_t read = 0;
    while (read < bytes) {
        if (read == text.size()) {
            const auto expected = static_cast<std::size_t>(size_) + 1; // so that the end shows
            text.resize(std::min(bytes, std::max({2 * read, expected, minRoom})));
        }
        const ssize_t count =
            ::pread(descriptor_, text.data() + read, text.size() - read, static_cast<off_t>(read));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return tl::unexpected(cannotOpen(file_, errno));
        }
        if (count == 0) {
            break;
        }
        read += static_cast<std::size_t>(count);
    }
    text.resize(read);
    return text;
}

Result<std::string> readFile(const fs::path& file, std::uintmax_t maxBytes) {
    return OrdinaryFile::open(file, maxBytes).and_then([](const OrdinaryFile& opened) {
        return opened.content();
    });
}

} // namespace patina
