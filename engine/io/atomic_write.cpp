// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/atomic_write.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace patina {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> cannotWrite(const fs::path& file, int cause) {
    return tl::unexpected(Error{file.string(), 0, 0,
                                "cannot be written: " + std::generic_category().message(cause),
                                {}});
}

/// Writes all bytes and flushes them to the disk. Returns 0, or the `errno` of the failure.
int writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return errno;
        }
        bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno; // EINVAL: not on a disk
}

fs::path behindLinks(const fs::path& file) {
    std::error_code failed;
    const fs::path target = fs::is_symlink(file, failed) ? fs::canonical(file, failed) : file;
    return failed ? file : target;
}

} // namespace

Result<void> writeAtomically(const fs::path& file, std::string_view bytes) {
    const fs::path target = behindLinks(file);
    const fs::path draft =
        target.parent_path() / fmt::format(".{}.{}", target.filename().string(), ::getpid());
    const int descriptor =
        ::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return cannotWrite(file, errno);
    }
    int cause = writeAll(descriptor, bytes);
    if (::close(descriptor) != 0 && cause == 0) {
        cause = errno;
    }
    if (cause == 0 && ::rename(draft.c_str(), target.c_str()) != 0) {
        cause = errno;
    }
    if (cause != 0) {
        ::unlink(draft.c_str());
        return cannotWrite(file, cause);
    }
    return {};
}

} // namespace patina
