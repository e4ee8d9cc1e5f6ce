// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/program.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <sys/wait.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/env.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/io.hpp>

namespace patina::tests {
namespace {

namespace process = boost::process;

process::environment environmentOf(const Start& start) {
    process::environment environment = boost::this_process::environment();
    for (const auto& [name, value] : start.environment) {
        if (value.empty()) {
            environment.erase(name);
        } else {
            environment[name] = value;
        }
    }
    return environment;
}

int exitCodeOf(const process::child& child) {
    const int status = child.native_exit_code();
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace

Outcome run(const std::filesystem::path& program, const Start& start) {
    const TemporaryFolder folder;
    writeFile(folder / "in", start.input);
    const auto began = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    process::child child(
        process::exe = program.string(), process::args = start.arguments, environmentOf(start),
        process::std_in<(folder / "in").string(), process::std_out>(folder / "out").string(),
        process::std_err > (folder / "err").string());
    // Asked again and again: wait_for of Boost 1.74 misses a child that ends before it waits.
    while (child.running() && seconds() < start.timeLimitSeconds) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const bool ended = !child.running();
    if (!ended) {
        child.terminate();
    }
    return {ended ? exitCodeOf(child) : -1, readFile(folder / "out"), readFile(folder / "err"),
            seconds()};
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "patina-test-XXXXXX").string();
    if (!mkdtemp(pattern.data())) {
        throw std::runtime_error("no temporary folder at " + pattern);
    }
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void makeCacheFolder(const std::filesystem::path& cache) {
    std::filesystem::create_directories(cache / "patina");
    for (const char* name : {"openness", "thumbnails"}) {
        const auto shared = std::filesystem::path(PATINA_BINARY_DIR) / name;
        std::filesystem::create_directories(shared);
        std::filesystem::create_directory_symlink(shared, cache / "patina" / name);
    }
}

std::string readFile(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void writeFile(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace patina::tests
