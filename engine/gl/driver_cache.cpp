// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/driver_cache.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace patina::gl {
namespace {

namespace fs = std::filesystem;

constexpr const char* disableWord = "MESA_SHADER_CACHE_DISABLE";

/// Is the size of the index in util/disk_cache_os.c of Mesa: a counter of 8 bytes, then 65536 keys
/// of 20 bytes.
constexpr off_t indexBytes = 8 + 65536 * 20;

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::string_view() : std::string_view(value);
}

/// Returns whether Mesa takes this value of a variable as true.
bool isTrue(std::string_view value) {
    return value == "1" || value == "true" || value == "y" || value == "yes" || value == "TRUE" ||
           value == "True";
}

/// Returns the folder that Mesa uses, found by its rules; empty where it finds none.
fs::path cacheFolder() {
    for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"}) {
        if (!variable(name).empty()) {
            return fs::path(variable(name)) / "mesa_shader_cache";
        }
    }
    return variable("HOME").empty() ? fs::path()
                                    : fs::path(variable("HOME")) / ".cache/mesa_shader_cache";
}

tl::unexpected<Error> unusable(const fs::path& file, int code) {
    return tl::unexpected(
        Error{file.string(), 0, 0,
              "the graphics driver keeps no programs here, so that they are compiled anew each "
              "time: " +
                  std::generic_category().message(code),
              "a folder that may be written to, with 2 MiB of room"});
}

std::optional<Error>& note() {
    static std::optional<Error> text;
    return text;
}

} // namespace

Result<void> reserveCacheIndex(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) {
        return unusable(folder, failed.value());
    }
    const fs::path index = folder / "index";
    const bool isNew = !fs::exists(index, failed);
    const int file = ::open(index.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0644);
    if (file < 0) {
        return unusable(folder, errno);
    }
    struct stat status {};
    ::fstat(file, &status);
    const int problem = S_ISREG(status.st_mode)
                            ? ::posix_fallocate(file, 0, std::max(indexBytes, status.st_size))
                            : EINVAL;
    ::close(file);
    if (problem != 0) {
        if (isNew) {
            fs::remove(index, failed);
        }
        return unusable(folder, problem);
    }
    return {};
}

void prepareDriverCache() {
    static std::once_flag once;
    std::call_once(once, [] {
        const fs::path folder = cacheFolder();
        if (folder.empty() || isTrue(variable(disableWord))) {
            return;
        }
        if (const auto reserved = reserveCacheIndex(folder); !reserved) {
            ::setenv(disableWord, "true", 1);
            note() = reserved.error();
        }
    });
}

const std::optional<Error>& driverCacheNote() {
    return note();
}

} // namespace patina::gl
