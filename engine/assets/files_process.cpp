// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/files_process.h"

#include <csignal>
#include <ctime>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/exception.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/io.hpp>
#include <boost/process/posix.hpp>
#include <sys/prctl.h>
#include <sys/resource.h>

#ifdef __has_feature
#define PATINA_HAS_FEATURE(x) __has_feature(x)
#else
#define PATINA_HAS_FEATURE(x) 0
#endif

namespace patina {
namespace {

namespace process = boost::process;

#if defined(__SANITIZE_ADDRESS__) || PATINA_HAS_FEATURE(address_sanitizer)
constexpr bool underSanitizer = true; // its shadow memory alone takes terabytes of address space
#else
constexpr bool underSanitizer = false;
#endif

/// Runs in the new process before the program starts: only calls that are safe after a fork.
void confine(std::size_t memoryLimitBytes, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) {
        ::_exit(127); // the parent died before it could be watched
    }
    if (!underSanitizer) {
        const rlimit memory{memoryLimitBytes, memoryLimitBytes};
        ::setrlimit(RLIMIT_AS, &memory);
        // Libraries print what the answer says better; standard output leads nowhere already.
        ::dup2(STDOUT_FILENO, STDERR_FILENO);
    }
    const rlimit noCoreFile{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCoreFile);
    ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC); // nothing of ours leaks into the program
}

} // namespace

struct FilesProcess::State {
    Channel channel;
    process::child child;
};

Result<FilesProcess> FilesProcess::start(const std::filesystem::path& program,
                                         std::size_t memoryLimitBytes) {
    auto [ours, theirs] = Channel::pair();
    if (!theirs) {
        return failure("cannot create a socket for the files process");
    }
    const pid_t parent = ::getpid();
    const auto setUp = [=](auto&) { confine(memoryLimitBytes, parent); };
    try {
        process::child child(
            process::exe = program.string(), process::posix::fd.bind(0, theirs.get()),
            process::std_out > process::null, process::extend::on_exec_setup = setUp);
        return FilesProcess(
            std::make_unique<State>(State{Channel(std::move(ours)), std::move(child)}));
    } catch (const process::process_error& problem) {
        return failure("cannot start " + program.string() + ": " + problem.code().message());
    }
}

FilesProcess::FilesProcess(std::unique_ptr<State> state) : state_(std::move(state)) {}
FilesProcess::FilesProcess(FilesProcess&&) noexcept = default;
FilesProcess& FilesProcess::operator=(FilesProcess&&) noexcept = default;

FilesProcess::~FilesProcess() {
    if (state_) {
        kill();
    }
}

const Channel& FilesProcess::channel() const { return state_->channel; }

double FilesProcess::workSeconds() const {
    clockid_t clock{};
    timespec time{};
    const bool isKnown = ::clock_getcpuclockid(state_->child.id(), &clock) == 0 &&
                         ::clock_gettime(clock, &time) == 0;
    return isKnown ? double(time.tv_sec) + 1e-9 * double(time.tv_nsec) : 0.0;
}

void FilesProcess::kill() {
    std::error_code ignored; // it may have ended by itself
    if (state_->child.valid() && state_->child.running(ignored)) {
        ::kill(state_->child.id(), SIGKILL); // child::terminate would leave a zombie behind
        state_->child.wait(ignored);
    }
}

} // namespace patina
