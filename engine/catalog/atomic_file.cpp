// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_text.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace patina {
namespace {

namespace fs = std::filesystem;

Error systemError(const fs::path& path, const std::string& what) {
    return {path.string(), 0, 0, what + ": " + std::strerror(errno), {}};
}

/// Owns a file that is open for writing.
class OutputFile {
  public:
    OutputFile(const fs::path& path, int flags) : descriptor_(::open(path.c_str(), flags, 0666)) {}
    ~OutputFile() { close(); }
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    bool isOpen() const { return descriptor_ >= 0; }

    bool write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR) {
                return false;
            }
            bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        }
        return true;
    }

    bool flush() { return ::fsync(descriptor_) == 0; }

    /// Gives the file the permissions, and where that is allowed the owner, of the one it replaces.
    bool copyRights(const struct stat& of) {
        const bool owned = ::fchown(descriptor_, of.st_uid, of.st_gid) == 0;
        // Without the owner the set-id bits would give somebody else's rights away.
        const mode_t rights = of.st_mode & (owned ? 07777u : 0777u);
        return ::fchmod(descriptor_, rights) == 0;
    }

    /// Closes the file. Some file systems report only here that the disk is full.
    bool close() { return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0; }

  private:
    int descriptor_;
};

/// Removes a file when it is destroyed, unless the file has been renamed away.
struct Remover {
    fs::path path;
    bool armed = false;
    ~Remover() {
        if (armed) {
            ::unlink(path.c_str());
        }
    }
};

/// Returns a path in the same folder that nothing else uses. The name is short, because the
/// target's may be long.
fs::path temporaryBeside(const fs::path& target) {
    static std::atomic<unsigned> counter = 0;
    return target.parent_path() / fmt::format(".patina-{}-{}.tmp", ::getpid(), counter++);
}

/// Writes to a device or a pipe, which cannot be replaced.
Result<void> writeInPlace(const fs::path& path, std::string_view bytes) {
    OutputFile file(path, O_WRONLY | O_CLOEXEC);
    if (!file.isOpen() || !file.write(bytes) || !file.close()) {
        return tl::unexpected(systemError(path, "cannot be written"));
    }
    return {};
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

Result<void> replace(const fs::path& target, const struct stat* old, std::string_view bytes) {
    Remover remover{temporaryBeside(target)};
    OutputFile file(remover.path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
    if (!file.isOpen()) {
        return tl::unexpected(systemError(target, "cannot be saved in its folder"));
    }
    remover.armed = true;
    const bool written = file.write(bytes) && (old == nullptr || file.copyRights(*old)) &&
                         file.flush() && file.close();
    if (!written || ::rename(remover.path.c_str(), target.c_str()) != 0) {
        return tl::unexpected(systemError(target, old == nullptr
                                                      ? "cannot be saved"
                                                      : "cannot be saved, the old file is "
                                                        "unchanged"));
    }
    remover.armed = false;
    flushFolder(target.parent_path());
    return {};
}

} // namespace

Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
    std::error_code status;
    // Through a link the file it names is replaced, not the link.
    fs::path target = fs::weakly_canonical(path, status);
    if (status) {
        target = fs::absolute(path, status);
    }
    struct stat old {};
    const bool exists = ::stat(target.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode)) {
        return tl::unexpected(Error{path.string(), 0, 0, "this is a folder", "a file name"});
    }
    if (exists && ::access(target.c_str(), W_OK) != 0) {
        return tl::unexpected(systemError(path, "is write-protected"));
    }
    if (exists && !S_ISREG(old.st_mode)) {
        return writeInPlace(target, bytes);
    }
    return replace(target, exists ? &old : nullptr, bytes);
}

} // namespace patina
