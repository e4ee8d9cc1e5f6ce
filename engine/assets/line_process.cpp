// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/line_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <fstream>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exception.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/io.hpp>
#include <boost/process/posix.hpp>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "assets/confinement.h"
#include "assets/file_handle.h"

namespace patina {

namespace process = boost::process;

namespace {

constexpr std::size_t maxLineBytes = std::size_t(1) << 20;

/// Returns a file in memory that holds a text and is read from its beginning; empty where the
/// system refuses. Unlike a pipe it takes any size without a reader.
FileHandle fileOf(const std::string& text) {
    FileHandle file(::memfd_create("patina", MFD_CLOEXEC));
    for (std::size_t done = 0; file && done < text.size();) {
        const ssize_t size = ::write(file.get(), text.data() + done, text.size() - done);
        if (size < 0 && errno != EINTR) {
            return {};
        }
        done += size > 0 ? std::size_t(size) : 0;
    }
    if (file) {
        ::lseek(file.get(), 0, SEEK_SET);
    }
    return file;
}

} // namespace

struct LineProcess::State {
    process::child child;
    FileHandle output;
    std::string unread;
    bool hasEnded = false;
    std::optional<End> end{};
};

Result<LineProcess> LineProcess::start(const Start& start) {
    const std::string name = start.program.filename().string();
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        return failure("cannot create a pipe for " + name);
    }
    FileHandle ours(ends[0]);
    const FileHandle theirs(ends[1]);
    const FileHandle input = fileOf(start.input);
    if (!input) {
        return failure("cannot write the input of " + name);
    }
    const pid_t parent = ::getpid();
    const Confinement limits{.data = start.memoryBytes, .stack = start.stackBytes};
    const auto setUp = [=](auto&) { confine(limits, parent); };
    try {
        process::child child(
            process::exe = start.program.string(), process::args = start.arguments,
            process::posix::fd.bind(0, input.get()), process::posix::fd.bind(1, theirs.get()),
            process::std_err > process::null, process::extend::on_exec_setup = setUp);
        return LineProcess(std::make_unique<State>(State{std::move(child), std::move(ours), {}}));
    } catch (const process::process_error& problem) {
        return failure("cannot start " + start.program.string() + ": " + problem.code().message());
    }
}

LineProcess::LineProcess(std::unique_ptr<State> state) : state_(std::move(state)) {}
LineProcess::LineProcess(LineProcess&&) noexcept = default;
LineProcess& LineProcess::operator=(LineProcess&&) noexcept = default;

LineProcess::~LineProcess() {
    if (state_) {
        end();
    }
}

std::optional<std::string> LineProcess::line(std::chrono::milliseconds patience) {
    std::string& unread = state_->unread;
    if (unread.find('\n') == std::string::npos && !state_->hasEnded) {
        pollfd waiting{state_->output.get(), POLLIN, 0};
        if (::poll(&waiting, 1, static_cast<int>(patience.count())) > 0) {
            std::array<char, 4096> chunk{};
            const ssize_t size = ::read(state_->output.get(), chunk.data(), chunk.size());
            unread.append(chunk.data(), size > 0 ? std::size_t(size) : 0);
            state_->hasEnded =
                size == 0 || (size < 0 && errno != EINTR) || unread.size() > maxLineBytes;
        }
    }
    const std::size_t end = unread.find('\n');
    if (end == std::string::npos) {
        return std::nullopt;
    }
    std::string line = unread.substr(0, end);
    unread.erase(0, end + 1);
    return line;
}

bool LineProcess::hasEnded() const {
    return state_->hasEnded && state_->unread.find('\n') == std::string::npos;
}

double LineProcess::workSeconds() const {
    clockid_t clock{};
    timespec time{};
    const bool isKnown = !state_->end && ::clock_getcpuclockid(state_->child.id(), &clock) == 0 &&
                         ::clock_gettime(clock, &time) == 0;
    return isKnown ? double(time.tv_sec) + 1e-9 * double(time.tv_nsec) : 0.0;
}

std::size_t LineProcess::memoryBytes() const {
    std::ifstream file("/proc/" + std::to_string(state_->child.id()) + "/statm");
    std::size_t all = 0;
    std::size_t resident = 0;
    const bool isKnown = !state_->end && bool(file >> all >> resident);
    return isKnown ? resident * std::size_t(::sysconf(_SC_PAGESIZE)) : 0;
}

LineProcess::End LineProcess::end() {
    if (state_->end) {
        return *state_->end;
    }
    const pid_t id = state_->child.id();
    ::kill(id, SIGKILL);    // does nothing where it has ended by itself
    state_->child.detach(); // wait4 below also tells how much memory it used
    int status = 0;
    rusage used{};
    while (::wait4(id, &status, 0, &used) < 0 && errno == EINTR) {
    }
    state_->end =
        End{WIFSIGNALED(status) ? WTERMSIG(status) : 0, WIFEXITED(status) ? WEXITSTATUS(status) : 0,
            std::size_t(used.ru_maxrss) * 1024};
    return *state_->end;
}

} // namespace patina
