// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <optional>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace patina {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> systemError(const fs::path& file, const std::string& what) {
    const std::string cause = std::generic_category().message(errno);
    return tl::unexpected(Error{file.string(), 0, 0, what + ": " + cause, {}});
}

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return true;
}

/// Gives a file the permissions, and where that is allowed the owner, of the one it replaces.
bool copyRights(int descriptor, const struct stat& of) {
    const bool owned = ::fchown(descriptor, of.st_uid, of.st_gid) == 0;
    // Without the owner the set-id bits would give somebody else's rights away.
    const mode_t rights = of.st_mode & (owned ? 07777u : 0777u);
    return ::fchmod(descriptor, rights) == 0;
}

/// Creates a file in the target's folder with a name that nothing else uses, and returns its
/// descriptor and path. The name is short, because the target's may be long.
std::pair<int, fs::path> createDraft(const fs::path& target) {
    static std::atomic<unsigned> counter = 0;
    fs::path draft;
    int descriptor = -1;
    do { // a draft of a process that was killed may have the name
        draft = target.parent_path() / fmt::format(".patina-{}-{}.tmp", ::getpid(), counter++);
        descriptor = ::open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    return {descriptor, std::move(draft)};
}

/// Flushes a folder, since a rename in it is safe on disk only afterwards. A failure is ignored:
/// the rename is then as safe as the file system makes it.
void flushFolder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

/// Returns what a path leads to: through a link the file it names is replaced, not the link.
fs::path behindLinks(const fs::path& file) {
    std::error_code failed;
    const fs::path target = fs::weakly_canonical(file, failed);
    return failed ? fs::absolute(file, failed) : target;
}

std::optional<struct stat> statusOf(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

/// Writes to a device or a pipe, which cannot be replaced.
Result<void> writeInPlace(const fs::path& file, std::string_view bytes) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) {
        return systemError(file, "cannot be written");
    }
    if (!writeAll(descriptor, bytes)) {
        const auto error = systemError(file, "cannot be written");
        ::close(descriptor);
        return error;
    }
    return ::close(descriptor) == 0 ? Result<void>() : systemError(file, "cannot be written");
}

} // namespace

Result<AtomicFile> AtomicFile::create(const fs::path& file) {
    const fs::path target = behindLinks(file);
    const auto old = statusOf(target);
    if (old && S_ISDIR(old->st_mode)) {
        return tl::unexpected(Error{file.string(), 0, 0, "this is a folder", "a file name"});
    }
    if (old && !S_ISREG(old->st_mode)) {
        return tl::unexpected(Error{file.string(), 0, 0, "is not an ordinary file", "a file"});
    }
    if (old && ::access(target.c_str(), W_OK) != 0) {
        return systemError(file, "is write-protected");
    }
    auto [descriptor, draft] = createDraft(target);
    if (descriptor < 0) {
        return systemError(target, "cannot be saved in its folder");
    }
    return AtomicFile(target, std::move(draft), descriptor);
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!draft_.empty()) {
        ::unlink(draft_.c_str());
    }
}

Result<void> AtomicFile::write(std::string_view bytes) {
    return writeAll(descriptor_, bytes) ? Result<void>() : cannotBeSaved();
}

Result<void> AtomicFile::commit() {
    const auto old = statusOf(target_);
    if ((old && !copyRights(descriptor_, *old)) || ::fsync(descriptor_) != 0) {
        return cannotBeSaved();
    }
    // Some file systems report only here that the disk is full.
    if (::close(std::exchange(descriptor_, -1)) != 0 ||
        ::rename(draft_.c_str(), target_.c_str()) != 0) {
        return cannotBeSaved();
    }
    draft_.clear();
    flushFolder(target_.parent_path());
    return {};
}

tl::unexpected<Error> AtomicFile::cannotBeSaved() const {
    const int cause = errno;
    const bool isThere = statusOf(target_).has_value();
    errno = cause;
    return systemError(target_,
                       isThere ? "cannot be saved, the old file is unchanged" : "cannot be saved");
}

Result<void> writeFileAtomically(const fs::path& file, std::string_view bytes) {
    const fs::path target = behindLinks(file);
    const auto old = statusOf(target);
    if (old && !S_ISREG(old->st_mode) && !S_ISDIR(old->st_mode)) {
        return writeInPlace(target, bytes);
    }
    auto draft = AtomicFile::create(file);
    if (!draft) {
        return tl::unexpected(draft.error());
    }
    return draft->write(bytes).and_then([&] { return draft->commit(); });
}

} // namespace patina
