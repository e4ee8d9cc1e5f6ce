// SPDX-License-Identifier: GPL-3.0-or-later
#include "observed_program.h"

#include <algorithm>
#include <chrono>
#include <initializer_list>
#include <sstream>
#include <thread>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/env.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>

#include "support/program.h"

namespace patina::benchmarks {

namespace process = boost::process;
using Clock = std::chrono::steady_clock;

class ObservedProgram::Implementation {
  public:
    Implementation(const std::filesystem::path& program, const std::vector<std::string>& arguments)
        : began_(Clock::now()),
          child_(process::exe = program.string(), process::args = arguments,
                 process::env["PATINA_TIME_STARTUP"] = "1", process::std_out > process::null,
                 process::std_err > (folder_ / "err").string()) {}

    ~Implementation() {
        std::error_code ignored;
        child_.terminate(ignored);
    }

    std::string messages() const { return tests::readFile(folder_ / "err"); }
    bool running() { return child_.running(); }

    std::string procFile(const std::string& name) const {
        return tests::readFile("/proc/" + std::to_string(child_.id()) + "/" + name);
    }

    double secondsRunning() const {
        return std::chrono::duration<double>(Clock::now() - began_).count();
    }

    /// Returns the seconds until one of the words was printed; negative as secondsToFirstFrame().
    double secondsUntil(std::initializer_list<const char*> words, double limitSeconds) {
        while (running() && secondsRunning() < limitSeconds) {
            const std::string said = messages();
            if (std::any_of(words.begin(), words.end(), [&](const char* word) {
                    return said.find(word) != std::string::npos;
                })) {
                return secondsRunning();
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return -1.0;
    }

  private:
    tests::TemporaryFolder folder_;
    Clock::time_point began_;
    process::child child_;
};

ObservedProgram::ObservedProgram(const std::filesystem::path& program,
                                 const std::vector<std::string>& arguments)
    : implementation_(std::make_unique<Implementation>(program, arguments)) {}

ObservedProgram::~ObservedProgram() = default;

double ObservedProgram::secondsToFirstFrame(double limitSeconds) {
    return implementation_->secondsUntil({"first frame"}, limitSeconds);
}

double ObservedProgram::secondsToFirstPicture(double limitSeconds) {
    return implementation_->secondsUntil({"sketch", "first frame"}, limitSeconds);
}

double ObservedProgram::residentMegabytes() const {
    const std::string status = implementation_->procFile("status");
    const auto at = status.find("VmRSS:");
    return at == std::string::npos ? 0.0 : std::stod(status.substr(at + 6)) / 1024.0;
}

long ObservedProgram::cpuTicks() const {
    // Fields 14 and 15 of /proc/<pid>/stat, counted after the name in brackets (field 2).
    const std::string stat = implementation_->procFile("stat");
    std::istringstream fields(stat.substr(stat.rfind(')') + 1));
    std::string skipped;
    for (int field = 3; field < 14; ++field) {
        fields >> skipped;
    }
    long user = 0;
    long system = 0;
    fields >> user >> system;
    return user + system;
}

} // namespace patina::benchmarks
