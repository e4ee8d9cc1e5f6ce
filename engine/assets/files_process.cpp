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

#include "assets/confinement.h"

namespace patina {

namespace process = boost::process;

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
    // What libraries print to standard error is dropped, since the answer has a better message.
    const Confinement limits{.addressSpace = memoryLimitBytes, .isQuiet = true};
    const auto setUp = [=](auto&) { confine(limits, parent); };
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
