// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/confinement.h"

#include <csignal>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __has_feature
#define PATINA_HAS_FEATURE(x) __has_feature(x)
#else
#define PATINA_HAS_FEATURE(x) 0
#endif

namespace patina {
namespace {

#if defined(__SANITIZE_ADDRESS__) || PATINA_HAS_FEATURE(address_sanitizer)
constexpr bool underSanitizer = true; // then no limit is set: shadow memory alone takes terabytes
                                      // of addresses
#else
constexpr bool underSanitizer = false;
#endif

void limit(__rlimit_resource resource, std::optional<std::size_t> bytes) {
    if (bytes) {
        const rlimit limit{*bytes, *bytes};
        ::setrlimit(resource, &limit);
    }
}

} // namespace

void confine(const Confinement& limits, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) {
        ::_exit(127); // the parent died before it could be watched
    }
    if (!underSanitizer) {
        limit(RLIMIT_AS, limits.addressSpace);
        limit(RLIMIT_DATA, limits.data);
        limit(RLIMIT_STACK, limits.stack);
        if (limits.isQuiet) {
            ::dup2(STDOUT_FILENO, STDERR_FILENO);
        }
    }
    limit(RLIMIT_CORE,
          1); // not 0: a program that reads cores from a pipe would still get them
    ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC); // nothing of ours leaks into the program
}

} // namespace patina
